#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "cam/solid/contours.h"
#include "cam/surface/surface_path.h"
#include "engine/drawing_path.h"
#include "runtime/script/paths/contour_choice.h"

namespace gsim::engine {

/// What of a request for contours is for drawings and flat parts alone, as a sentence; empty: nothing.
std::string misplaced_with_contours(const DrawingRequest& request);

/// What scripts and lists are told of a contour.
script::ContourFacts facts_of(const solid::WallContour& contour);

/// Reads contours of a part through the host. The error is a sentence.
tl::expected<solid::WallContours, std::string> read_part_contours(const Host& host, const std::string& file,
                                                                  const ContourChoice& choice);

/// Those of a request, with its tolerance.
tl::expected<solid::WallContours, std::string> read_surface_input(const Host& host, const std::string& file,
                                                                  const DrawingRequest& request);

/// Leaves those of which the script of a file is true. The error is "file:line: sentence".
tl::expected<void, std::string> choose_contours(std::string_view script, const std::string& file_name,
                                                solid::WallContours& part);

/// How the contours that a request names become a path.
surface::SurfaceOptions surface_options(const DrawingRequest& request);

}  // namespace gsim::engine
