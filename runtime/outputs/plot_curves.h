#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/outputs/gnuplot_script.h"
#include "runtime/outputs/plot_data.h"

namespace gsim::simulation {

/// Returns true if the machine has axes of a kind.
bool has_axes(const PlotData& data, machine::AxisKind kind);

/// Panel with a curve for each of several axes over time.
class AxisCurves {
  public:
    explicit AxisCurves(GnuplotScript& script) : script_(script) {}

    /// Adds a curve. `name`: of the data, such as "effort_X". `colour`: by the number of the axis.
    void add(std::string_view name, const std::vector<TimePoint>& points, std::size_t colour,
             std::string_view title);
    /// Draws all curves that were added.
    void draw(std::string_view label);

  private:
    GnuplotScript& script_;
    std::string command_;
    double end_s_ = 0;
};

}  // namespace gsim::simulation
