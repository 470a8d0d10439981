#include "runtime/report/report_following.h"

#include <cmath>

#include <fmt/format.h>

#include "runtime/report/json_values.h"
#include "runtime/report/text_helpers.h"

namespace gsim::simulation {

namespace {

constexpr double kMsPerS = 1000;
constexpr std::size_t kLocationWidth = 30;

std::string following_unit(const AxisFollowing& axis) {
    return axis.rotary ? "deg" : "mm";
}

Json following_axis_json(const Report& report, const AxisFollowing& axis) {
    const bool has_lag = axis.peak != 0;
    return {{"axis", letter(axis.letter)},
            {"unit", following_unit(axis)},
            {"position_gain_1_s", number(axis.gain_1_s)},
            {"lag_s", number(axis.constant_speed_lag_s)},
            {"peak", number(axis.peak)},
            {"t_s", number(axis.peak_t_s)},
            {"file", has_lag ? file(report, axis.peak_location) : Json(nullptr)},
            {"line", has_lag ? line(axis.peak_location) : Json(nullptr)},
            {"rms", number(axis.rms)},
            {"end", number(axis.end)}};
}

Json contour_json(const Report& report, const ContourError& contour) {
    const bool left = contour.error_mm > 0;
    return {{"error_mm", number(contour.error_mm)},
            {"t_s", number(contour.t_s)},
            {"file", left ? file(report, contour.location) : Json(nullptr)},
            {"line", left ? line(contour.location) : Json(nullptr)}};
}

std::string contour_text(const Report& report, const ContourError& contour) {
    std::string text = fmt::format("{:.4f} mm", contour.error_mm);
    if (contour.error_mm > 0) text += " at " + location_text(report, contour.location, kLocationWidth);
    return text;
}

}  // namespace

nlohmann::ordered_json following_json(const Report& report) {
    const FollowingReport& following = *report.drives.following;
    Json axes = Json::array();
    for (const AxisFollowing& axis : following.axes) axes.push_back(following_axis_json(report, axis));
    return {{"axes", std::move(axes)},
            {"contour", contour_json(report, following.feed)},
            {"rapid_contour", contour_json(report, following.rapid)},
            {"program_contour", following.program ? contour_json(report, *following.program) : Json(nullptr)},
            {"in_position_mm", number(following.band_mm)},
            {"in_position_deg", number(following.band_deg)},
            {"in_position_s", number(following.in_position_s)}};
}

std::string following_text(const Report& report) {
    const FollowingReport& following = *report.drives.following;
    std::string out =
        fmt::format("\n{:<15}{:>11}{:>12}{:>14}   {}\n", "following", "peak", "rms", "delay (ms)", "peak at");
    for (const AxisFollowing& axis : following.axes) {
        std::string row =
            fmt::format("{} {:<13}{:>11.4f}{:>12.4f}{:>14.3f}   {}", axis.letter, following_unit(axis),
                        axis.peak, axis.rms, kMsPerS * axis.constant_speed_lag_s,
                        axis.peak != 0 ? location_text(report, axis.peak_location, kLocationWidth) : "");
        row.erase(row.find_last_not_of(' ') + 1);
        out += row + '\n';
    }
    out += fmt::format("contour     {}\n", contour_text(report, following.feed));
    if (following.rapid.error_mm > 0)
        out += fmt::format("            {}, in rapid moves\n", contour_text(report, following.rapid));
    if (following.program) {
        out += fmt::format("            {}, from the programmed path\n",
                           contour_text(report, *following.program));
    }
    out += following.in_position_s
               ? fmt::format("in position {:.4f} s after the end\n", *following.in_position_s)
               : std::string("in position not within 20 time constants after the end\n");
    return out;
}

}  // namespace gsim::simulation
