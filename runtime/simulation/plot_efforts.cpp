#include "runtime/simulation/plot_efforts.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace gsim::simulation {

namespace {

// Dark enough on white, and told apart by most eyes (Okabe, Ito: Color Universal Design, 2008).
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};

bool has(const PlotData& data, machine::AxisKind kind) {
    return std::any_of(data.axes().begin(), data.axes().end(),
                       [kind](const machine::Axis& axis) { return axis.kind == kind; });
}

void add_curve(GnuplotScript& script, const std::vector<TimePoint>& points, char letter) {
    script.begin_data(fmt::format("effort_{}", letter));
    for (const TimePoint& point : points) script.point(point.t_s, point.value);
    script.end_data();
}

}  // namespace

std::size_t effort_panels(const PlotData& data) {
    if (!data.has_efforts()) return 0;
    return (has(data, machine::AxisKind::linear) ? 1U : 0U) +
           (has(data, machine::AxisKind::rotary) ? 1U : 0U);
}

void add_effort_panel(GnuplotScript& script, const PlotData& data, std::size_t panel) {
    const bool linear = panel == 0 && has(data, machine::AxisKind::linear);
    const machine::AxisKind kind = linear ? machine::AxisKind::linear : machine::AxisKind::rotary;
    std::string command;
    double end_s = 0;
    for (std::size_t i = 0; i < data.axes().size(); ++i) {
        if (data.axes()[i].kind != kind) continue;
        const char letter = data.axes()[i].letter;
        const std::vector<TimePoint> points = data.efforts(i);
        if (!points.empty()) end_s = std::max(end_s, points.back().t_s);
        add_curve(script, points, letter);
        command +=
            fmt::format("{}$effort_{} with lines linewidth 1.2 linecolor rgb '{}' title '{}'",
                        command.empty() ? "plot " : ", ", letter, kColours[i % kColours.size()], letter);
    }
    script.line("set size noratio");
    script.line("set xrange [0:{:.9g}]", end_s > 0 ? end_s : 1);
    script.line("set yrange [*:*]");
    script.line("set xlabel 'time (s)'");
    script.line("set ylabel '{}' noenhanced", linear ? "force (N)" : "torque (Nm)");
    script.line("unset y2tics");
    script.line("unset y2label");
    script.line("{}", command);
}

}  // namespace gsim::simulation
