#pragma once

#include <string>
#include <string_view>

#include "runtime/outputs/plot_data.h"

namespace gsim::simulation {

enum class PictureFormat { svg, png };

/// Returns the gnuplot script, data included, that draws a Picture to standard output.
std::string plot_script(const PlotData& data, PictureFormat format, std::string_view title);

}  // namespace gsim::simulation
