#pragma once

#include <string>

#include "base/error.h"
#include "cam/solid/occ/shape_file.h"
#include "cam/solid/plate.h"

namespace gsim::solid {

/// Returns the outlines of the plate in a file: of its bodies; without bodies, of its flat surfaces; without
/// those, its curves.
Result<Plate> extract_plate(const ShapeFile& file, const PlateOptions& options);

}  // namespace gsim::solid
