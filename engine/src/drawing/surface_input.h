#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "cam/solid/contours.h"
#include "cam/surface/surface_path.h"
#include "engine/drawing_path.h"
#include "runtime/script/paths/contour_selection.h"

namespace gsim::engine {

/// Returns an error if a request for contours has options that are only for drawings and flat parts.
std::optional<gsim::Error> find_contour_option_error(const DrawingRequest& request);

/// Returns the facts about a contour for scripts and lists.
script::ContourDescription describe_contour(const solid::WallContour& contour);

/// Reads contours of a part through the host.
Result<solid::WallContours> read_part_contours(const Host& host, const std::string& file,
                                               const ContourSelection& selection);

/// Reads those of a request, with its tolerance.
Result<solid::WallContours> read_surface_input(const Host& host, const std::string& file,
                                               const DrawingRequest& request);

/// Keeps the contours for which the script of a file is true. The error is "file:line: message".
Result<void> choose_contours(std::string_view script, const std::string& file_name,
                             solid::WallContours& part);

/// Returns the options for making a path from the contours that a request names.
surface::SurfaceOptions surface_options(const DrawingRequest& request);

}  // namespace gsim::engine
