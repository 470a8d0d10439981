#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cam/solid/contours.h"
#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// Returns the contours of the bodies of a file, as the options select them. The error is a message.
tl::expected<WallContours, std::string> extract_contours(const ShapeFile& file,
                                                         const ContourOptions& options);

}  // namespace gsim::solid
