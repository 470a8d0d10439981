#include "runtime/outputs/plot_curves.h"

#include <algorithm>
#include <array>

namespace gsim::simulation {

namespace {

// Dark enough on white, and distinguishable for most people (Okabe, Ito: Color Universal Design, 2008).
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};

}  // namespace

bool has_axes(const PlotData& data, machine::AxisKind kind) {
    return std::any_of(data.axes().begin(), data.axes().end(),
                       [kind](const machine::Axis& axis) { return axis.kind == kind; });
}

void AxisCurves::add(std::string_view name, const std::vector<TimePoint>& points, std::size_t colour,
                     std::string_view title) {
    if (!points.empty()) end_s_ = std::max(end_s_, points.back().t_s);
    script_.begin_data(name);
    for (const TimePoint& point : points) script_.point(point.t_s, point.value);
    script_.end_data();
    command_ +=
        fmt::format("{}${} with lines linewidth 1.2 linecolor rgb '{}' title '{}'",
                    command_.empty() ? "plot " : ", ", name, kColours[colour % kColours.size()], title);
}

void AxisCurves::draw(std::string_view label) {
    script_.line("set size noratio");
    script_.line("set xrange [0:{:.9g}]", end_s_ > 0 ? end_s_ : 1);
    script_.line("set yrange [*:*]");
    script_.line("set xlabel 'time (s)'");
    script_.line("set ylabel '{}' noenhanced", label);
    script_.line("unset y2tics");
    script_.line("unset y2label");
    script_.line("{}", command_);
}

}  // namespace gsim::simulation
