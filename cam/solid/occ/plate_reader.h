#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cam/solid/occ/shape_file.h"
#include "cam/solid/plate.h"

namespace gsim::solid {

/// The outlines of the plate in a file: of its bodies; where there is none, of its flat surfaces; where there
/// is none either, its curves. The error is a sentence.
tl::expected<Plate, std::string> plate_of(const ShapeFile& file, const PlateOptions& options);

}  // namespace gsim::solid
