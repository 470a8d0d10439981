#pragma once

#include <cstddef>

#include "runtime/outputs/gnuplot_script.h"
#include "runtime/outputs/plot_data.h"

namespace gsim::simulation {

/// Returns the number of panels for following errors over time: one for mm, which has the contour error, too,
/// and one for deg if the machine has rotary axes; or none.
std::size_t following_panels(const PlotData& data);
/// Adds one of them, by its number: mm come first.
void add_following_panel(GnuplotScript& script, const PlotData& data, std::size_t panel);

}  // namespace gsim::simulation
