#pragma once

#include <cstddef>

#include "runtime/outputs/gnuplot_script.h"
#include "runtime/outputs/plot_data.h"

namespace gsim::simulation {

/// How many panels show following errors over time: one for mm, in which the contour error is, too, and one
/// for deg where the machine has rotary axes; or none.
std::size_t following_panels(const PlotData& data);
/// One of them, by its number: mm come first.
void add_following_panel(GnuplotScript& script, const PlotData& data, std::size_t panel);

}  // namespace gsim::simulation
