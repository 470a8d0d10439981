#pragma once

#include <string>

#include "base/error.h"
#include "cam/solid/contours.h"
#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// Returns the contours of the bodies of a file, as the options select them.
Result<WallContours> extract_contours(const ShapeFile& file, const ContourOptions& options);

}  // namespace gsim::solid
