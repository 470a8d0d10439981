#pragma once

#include <string>

#include <tl/expected.hpp>

#include "solid/occ/shape_file.h"
#include "solid/plate.h"

namespace gsim::solid {

/// The outlines of the plate in a file: of its bodies; where there is none, of its flat surfaces; where there
/// is none either, its curves. The error is a sentence.
tl::expected<Plate, std::string> plate_of(const ShapeFile& file, const PlateOptions& options);

}  // namespace gsim::solid
