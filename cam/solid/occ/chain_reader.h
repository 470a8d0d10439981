#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cam/solid/contours.h"
#include "cam/solid/occ/plate_bodies.h"
#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// The edges that were asked for by their numbers, in chains, and what else of their bodies a jet could come
/// into. `bodies` are those of the file; the box about them is left to the caller. The error is a sentence.
tl::expected<WallContours, std::string> chains_of(const ShapeFile& file, const Bodies& bodies,
                                                  const ContourOptions& options);

}  // namespace gsim::solid
