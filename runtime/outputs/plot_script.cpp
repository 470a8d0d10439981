#include "runtime/outputs/plot_script.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "runtime/outputs/gnuplot_script.h"
#include "runtime/outputs/plot_efforts.h"
#include "runtime/outputs/plot_following.h"

namespace gsim::simulation {

namespace {

constexpr double kWidth_px = 1100;
constexpr double kTitle_px = 50;
constexpr double kTimePanel_px = 300;   // of each of the panels over time
constexpr double kMaxLimitToCurve = 2;  // a dashed limit further above the curve would press it flat
constexpr double kMargin_px = 130;      // of the path panel: labels and legend
constexpr double kMinPath_px = 200;
constexpr double kMaxPath_px = 900;
constexpr std::size_t kMaxTitleLength = 90;

struct PlotRange {
    double min = 0;
    double max = 0;

    void include(double value) {
        min = std::min(min, value);
        max = std::max(max, value);
    }
    double size() const { return max - min; }
    PlotRange widened(double by) const { return {min - by, max + by}; }
};

struct Extents {
    PlotRange x, y;
};

Extents extents(const std::vector<PathPoint>& path) {
    Extents extents;
    if (path.empty()) return {{0, 1}, {0, 1}};
    extents.x = {path[0].at_mm.x(), path[0].at_mm.x()};
    extents.y = {path[0].at_mm.y(), path[0].at_mm.y()};
    for (const PathPoint& point : path) {
        extents.x.include(point.at_mm.x());
        extents.y.include(point.at_mm.y());
    }
    const double greater = std::max(extents.x.size(), extents.y.size());
    const double border = greater > 0 ? 0.04 * greater : 1;
    return {extents.x.widened(border), extents.y.widened(border)};
}

// Returns a gnuplot string in single quotes, in which only the quote is special.
std::string quoted_text(std::string_view text) {
    std::string out = "'";
    for (const char c : text.substr(0, kMaxTitleLength)) {
        if (c == '\'') out += '\'';
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
    return out + (text.size() > kMaxTitleLength ? "...'" : "'");
}

// Writes the polylines of one style; returns true if any exist.
bool add_path_data(GnuplotScript& script, std::string_view name, const std::vector<PathPoint>& path,
                   PathStyle style) {
    bool any = false;
    script.begin_data(name);
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (path[i].style != style) continue;
        if (i == 1 || path[i - 1].style != style) {
            if (any) script.gap();
            script.point(path[i - 1].at_mm.x(), path[i - 1].at_mm.y());
        }
        script.point(path[i].at_mm.x(), path[i].at_mm.y());
        any = true;
    }
    script.end_data();
    return any;
}

// Writes the same for values over time.
bool add_time_data(GnuplotScript& script, std::string_view name, const std::vector<TimePoint>& points,
                   PathStyle style) {
    bool any = false;
    script.begin_data(name);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].style != style) continue;
        if (any && points[i - 1].style != style) script.gap();
        script.point(points[i].t_s, points[i].value);
        any = true;
    }
    script.end_data();
    return any;
}

bool add_mark_data(GnuplotScript& script, std::string_view name, const std::vector<PlotMark>& marks,
                   MarkKind kind) {
    bool any = false;
    script.begin_data(name);
    for (const PlotMark& mark : marks) {
        if (mark.kind != kind) continue;
        script.point(mark.at_mm.x(), mark.at_mm.y());
        any = true;
    }
    script.end_data();
    return any;
}

// Holds each value until the next one. No line is drawn at a change, so that frequent changes of the feed do
// not fill the picture.
bool add_steps_data(GnuplotScript& script, std::string_view name, const std::vector<TimePoint>& points) {
    script.begin_data(name);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0 && points[i].value != points[i - 1].value) {
            script.point(points[i].t_s, points[i - 1].value);
            script.gap();
        }
        script.point(points[i].t_s, points[i].value);
    }
    script.end_data();
    return !points.empty();
}

void add_plot_command(GnuplotScript& script, const std::vector<std::string>& curves) {
    std::string command;
    for (const std::string& curve : curves) command += (command.empty() ? "plot " : ", ") + curve;
    script.line("{}", command.empty() ? "plot NaN notitle" : command);
}

void add_marks(GnuplotScript& script, const std::vector<PlotMark>& marks, std::vector<std::string>& curves) {
    if (add_mark_data(script, "pierce", marks, MarkKind::pierce)) {
        curves.emplace_back(
            "$pierce with points pointtype 6 pointsize 1.2 linewidth 1.5 linecolor rgb '#2f7d4f' title "
            "'pierce'");
    }
    if (add_mark_data(script, "collision", marks, MarkKind::collision)) {
        curves.emplace_back(
            "$collision with points pointtype 3 pointsize 1.8 linewidth 2 linecolor rgb '#b0207a' title "
            "'collision'");
    }
    if (add_mark_data(script, "alarm", marks, MarkKind::alarm)) {
        curves.emplace_back(
            "$alarm with points pointtype 2 pointsize 2 linewidth 3 linecolor rgb '#d11f1f' title 'alarm'");
    }
}

void add_path_panel(GnuplotScript& script, const PlotData& data, const Extents& extents) {
    const std::vector<PathPoint> path = data.path();
    std::vector<std::string> curves;
    if (add_path_data(script, "rapid", path, PathStyle::rapid)) {
        curves.push_back(
            "$rapid with lines linewidth 1.3 dashtype '-' linecolor rgb '#c0772b' title 'rapid'");
    }
    if (add_path_data(script, "feed", path, PathStyle::feed)) {
        curves.push_back(fmt::format(
            "$feed with lines linewidth 1.2 linecolor rgb '#7c828c' title 'feed, {} off'", data.process()));
    }
    if (add_path_data(script, "jet", path, PathStyle::jet)) {
        curves.push_back(
            fmt::format("$jet with lines linewidth 2 linecolor rgb '#12355b' title '{} on'", data.process()));
    }
    if (add_path_data(script, "beyond", path, PathStyle::out_of_range)) {
        curves.push_back("$beyond with lines linewidth 3 linecolor rgb '#d01c1c' title 'past a limit'");
    }
    add_marks(script, data.marks(), curves);
    script.line("set size ratio -1");
    script.line("set xrange [{:.9g}:{:.9g}]", extents.x.min, extents.x.max);
    script.line("set yrange [{:.9g}:{:.9g}]", extents.y.min, extents.y.max);
    script.line("set xlabel {} noenhanced", quoted_text(data.labels()[0]));
    script.line("set ylabel {} noenhanced", quoted_text(data.labels()[1]));
    add_plot_command(script, curves);
}

bool is_rapid(const TimePoint& point) {
    return point.style == PathStyle::rapid;
}

PlotRange values(const std::vector<TimePoint>& points, bool rapids_only) {
    PlotRange range;
    for (const TimePoint& point : points) {
        if (is_rapid(point) == rapids_only) range.include(point.value);
    }
    return range;
}

// Values of a panel over time. If it has rapids and other moves each have a scale, on the right and on the
// left: rapids would press all cutting values flat.
struct TimeScales {
    explicit TimeScales(const std::vector<TimePoint>& points)
        : cutting(values(points, false)),
          rapids(values(points, true)),
          has_two_scales(cutting.size() > 0 && rapids.size() > 0),
          end_s(points.empty() ? 0 : points.back().t_s) {}

    PlotRange cutting, rapids;
    bool has_two_scales;
    double end_s;

    /// Returns the range on the left.
    PlotRange& left() { return cutting.size() > 0 ? cutting : rapids; }
};

// Sets the zero of both scales to one height.
void set_time_axes(GnuplotScript& script, TimeScales& scales, std::string_view what, std::string_view unit) {
    PlotRange left = scales.left();
    if (scales.has_two_scales && scales.rapids.min < 0) left.include(-left.max);
    if (scales.has_two_scales && scales.rapids.max > 0) left.include(-left.min);
    script.line("set size noratio");
    script.line("set xrange [0:{:.9g}]", scales.end_s > 0 ? scales.end_s : 1);
    script.line("set yrange [{:.9g}:{:.9g}]", 1.08 * left.min, left.size() > 0 ? 1.08 * left.max : 1);
    script.line("set xlabel 'time (s)'");
    script.line("set ylabel '{} ({})' noenhanced", what, unit);
    script.line("unset y2tics");
    script.line("unset y2label");
    script.line("set ytics nomirror");
    if (!scales.has_two_scales) return;
    double factor = scales.rapids.max / left.max;
    if (left.min < 0) factor = std::max(factor, scales.rapids.min / left.min);
    script.line("set y2range [{:.9g}:{:.9g}]", 1.08 * factor * left.min, 1.08 * factor * left.max);
    script.line("set y2tics textcolor rgb '#c0772b'");
    script.line("set y2label 'rapid ({})' noenhanced textcolor rgb '#c0772b'", unit);
}

std::vector<std::string> time_curves(GnuplotScript& script, const std::string& name,
                                     const std::vector<TimePoint>& points, const TimeScales& scales,
                                     std::string_view process) {
    std::vector<std::string> curves;
    if (add_time_data(script, name + "_rapid", points, PathStyle::rapid)) {
        curves.push_back(fmt::format("${}_rapid {} with lines linewidth 1 linecolor rgb '#c0772b' title '{}'",
                                     name, scales.has_two_scales ? "axes x1y2" : "axes x1y1",
                                     scales.has_two_scales ? "rapid (right)" : "rapid"));
    }
    if (add_time_data(script, name + "_off", points, PathStyle::feed)) {
        curves.push_back(fmt::format(
            "${}_off with lines linewidth 1.2 linecolor rgb '#7c828c' title '{} off'", name, process));
    }
    if (add_time_data(script, name + "_on", points, PathStyle::jet)) {
        curves.push_back(fmt::format("${}_on with lines linewidth 1.5 linecolor rgb '#12355b' title '{} on'",
                                     name, process));
    }
    return curves;
}

void add_speed_panel(GnuplotScript& script, const PlotData& data) {
    const std::vector<TimePoint> speed = data.speed();
    const std::vector<TimePoint> feed = data.feed();
    TimeScales scales(speed);
    std::vector<std::string> curves = time_curves(script, "speed", speed, scales, data.process());
    const bool jet = std::any_of(speed.begin(), speed.end(),
                                 [](const TimePoint& point) { return point.style == PathStyle::jet; });
    if (jet)
        curves.insert(curves.begin(), "$speed_on with filledcurves y1=0 fillcolor rgb '#c9d7e8' notitle");
    if (add_steps_data(script, "programmed", feed)) {
        curves.emplace_back(
            "$programmed with lines linewidth 1.2 dashtype '-' linecolor rgb '#a23b3b' title 'feed as "
            "programmed'");
    }
    PlotRange& range = scales.left();
    range.include(std::min(values(feed, false).max, kMaxLimitToCurve * range.max));
    set_time_axes(script, scales, "speed", "mm/s");
    add_plot_command(script, curves);
}

void add_acceleration_panel(GnuplotScript& script, const PlotData& data) {
    const std::vector<TimePoint> acceleration = data.acceleration();
    TimeScales scales(acceleration);
    std::vector<std::string> curves =
        time_curves(script, "acceleration", acceleration, scales, data.process());
    PlotRange& range = scales.left();
    const double limit = data.max_acceleration_mm_s2();
    if (range.size() > 0 && limit <= kMaxLimitToCurve * std::max(range.max, -range.min)) {
        curves.push_back(fmt::format(
            "{0:.9g} with lines linewidth 1.2 dashtype '-' linecolor rgb '#a23b3b' title 'limit of feed "
            "moves', -{0:.9g} with lines linewidth 1.2 dashtype '-' linecolor rgb '#a23b3b' notitle",
            limit));
        range.include(limit);
        range.include(-limit);
    }
    set_time_axes(script, scales, "acceleration", "mm/s^2");
    add_plot_command(script, curves);
}

// Returns the height of the path's axes if they fill the width of the picture.
double path_height_px(const Extents& extents) {
    const double required_px = (kWidth_px - kMargin_px) * extents.y.size() / extents.x.size();
    return std::clamp(required_px, kMinPath_px, kMaxPath_px);
}

}  // namespace

std::string plot_script(const PlotData& data, PictureFormat format, std::string_view title) {
    const Extents path_extents = extents(data.path());
    const double path_px = path_height_px(path_extents) + kMargin_px;
    const std::size_t efforts = effort_panels(data);
    const std::size_t panels = 2 + efforts + following_panels(data);
    const double height_px = kTitle_px + path_px + static_cast<double>(panels) * kTimePanel_px;
    const double time_share = kTimePanel_px / height_px;

    GnuplotScript script;
    const bool svg = format == PictureFormat::svg;
    script.line("set terminal {} size {:.0f},{:.0f} font '{},13' background rgb 'white'",
                svg ? "svg dynamic" : "pngcairo", kWidth_px, height_px,
                svg ? "DejaVu Sans, sans-serif" : "Sans");
    script.line("set multiplot");
    script.line("set label 1 {} at screen 0.5, {:.6f} center noenhanced font ',16'", quoted_text(title),
                1 - 0.5 * kTitle_px / height_px);
    script.line("set border linecolor rgb '#555555'");
    script.line("set grid linetype 1 linewidth 0.5 linecolor rgb '#e3e3e3'");
    script.line("set tics nomirror");
    script.line("set lmargin 10");
    script.line("set rmargin 11");
    script.line("set key outside top center horizontal samplen 3 width 1 textcolor rgb '#333333'");
    const auto set_origin = [&](std::size_t above) {
        script.line("set origin 0, {:.6f}", static_cast<double>(above) * time_share);
    };
    set_origin(panels);
    script.line("set size 1, {:.6f}", path_px / height_px);
    add_path_panel(script, data, path_extents);
    script.line("unset label 1");
    script.line("set size 1, {:.6f}", time_share);
    set_origin(panels - 1);
    add_speed_panel(script, data);
    set_origin(panels - 2);
    add_acceleration_panel(script, data);
    for (std::size_t i = 0; i + 2 < panels; ++i) {
        set_origin(panels - 3 - i);
        if (i < efforts) {
            add_effort_panel(script, data, i);
        } else {
            add_following_panel(script, data, i - efforts);
        }
    }
    script.line("unset multiplot");
    return script.release();
}

}  // namespace gsim::simulation
