#include "runtime/outputs/plot_efforts.h"

#include "runtime/outputs/plot_curves.h"

namespace gsim::simulation {

std::size_t effort_panels(const PlotData& data) {
    if (!data.has_efforts()) return 0;
    return (has_axes(data, machine::AxisKind::linear) ? 1U : 0U) +
           (has_axes(data, machine::AxisKind::rotary) ? 1U : 0U);
}

void add_effort_panel(GnuplotScript& script, const PlotData& data, std::size_t panel) {
    const bool linear = panel == 0 && has_axes(data, machine::AxisKind::linear);
    const machine::AxisKind kind = linear ? machine::AxisKind::linear : machine::AxisKind::rotary;
    AxisCurves curves(script);
    for (std::size_t i = 0; i < data.axes().size(); ++i) {
        if (data.axes()[i].kind != kind) continue;
        const std::string letter(1, data.axes()[i].letter);
        curves.add("effort_" + letter, data.efforts(i), i, letter);
    }
    curves.draw(linear ? "force (N)" : "torque (Nm)");
}

}  // namespace gsim::simulation
