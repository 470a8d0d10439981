#include "runtime/outputs/plot_following.h"

#include "runtime/outputs/plot_curves.h"

namespace gsim::simulation {

std::size_t following_panels(const PlotData& data) {
    if (!data.has_following()) return 0;
    return has_axes(data, machine::AxisKind::rotary) ? 2 : 1;
}

void add_following_panel(GnuplotScript& script, const PlotData& data, std::size_t panel) {
    const machine::AxisKind kind = panel == 0 ? machine::AxisKind::linear : machine::AxisKind::rotary;
    AxisCurves curves(script);
    for (std::size_t i = 0; i < data.axes().size(); ++i) {
        if (data.axes()[i].kind != kind) continue;
        const std::string letter(1, data.axes()[i].letter);
        curves.add("following_" + letter, data.following(i), i, letter);
    }
    if (panel == 0) curves.add("contour", data.contour(), data.axes().size(), "contour error of the TCP");
    curves.draw(panel == 0 ? "following error (mm)" : "following error (deg)");
}

}  // namespace gsim::simulation
