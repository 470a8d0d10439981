#pragma once

#include <string>

#include "base/error.h"
#include "cam/solid/contours.h"
#include "cam/solid/occ/plate_bodies.h"
#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// Returns the edges requested by their numbers, in chains, and other edges of their bodies that a jet could
/// hit. `bodies` are those of the file; the caller computes their bounding box.
Result<WallContours> extract_chains(const ShapeFile& file, const Bodies& bodies,
                                    const ContourOptions& options);

}  // namespace gsim::solid
