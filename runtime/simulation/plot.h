#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "runtime/simulation/plot_data.h"

namespace gsim::simulation {

/// Draws a run as a picture, .svg or .png by the name of the file: the path from above at equal scales, jet
/// on dark, jet off grey, rapids dashed; below it the speed of the tool over time with the programmed feed,
/// and the acceleration along the path. It needs gnuplot. The error is a sentence; then no picture is left,
/// and one that was there before stays.
tl::expected<void, std::string> make_plot(const PlotData& data, const std::filesystem::path& path,
                                          std::string_view title);

}  // namespace gsim::simulation
