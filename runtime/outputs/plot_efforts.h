#pragma once

#include <cstddef>

#include "runtime/outputs/gnuplot_script.h"
#include "runtime/outputs/plot_data.h"

namespace gsim::simulation {

/// Returns the number of panels for forces and torques over time: one for each that the machine's axes have,
/// or none.
std::size_t effort_panels(const PlotData& data);
/// Adds one of them, by its number: forces come first.
void add_effort_panel(GnuplotScript& script, const PlotData& data, std::size_t panel);

}  // namespace gsim::simulation
