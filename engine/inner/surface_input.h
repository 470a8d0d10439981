#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cam/solid/contours.h"
#include "cam/surface/surface_path.h"
#include "engine/drawing_path.h"

namespace gsim::engine {

/// Reads the contours of a part through the host. The error is a sentence: why it cannot be read, or what of
/// the choice is not for such a part.
tl::expected<solid::WallContours, std::string> read_surface_input(const Host& host, const std::string& file,
                                                                  const DrawingRequest& request);

/// How the contours that a request names become a path.
surface::SurfaceOptions surface_options(const DrawingRequest& request);

}  // namespace gsim::engine
