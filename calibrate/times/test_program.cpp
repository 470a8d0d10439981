// Part programs that determine the parameters missing in recorded runs.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "calibrate/times/fit_output.h"

namespace gsim::calibrate {

namespace {

using machine::Axis;

constexpr double kMaxRangeShare = 0.4;
constexpr double kMaxReach = 100;  // mm or deg

/// Returns the distance by which a test may move an axis from its home position, to the side with more
/// travel.
double axis_reach(const Axis& axis) {
    const double up = axis.max - axis.home, down = axis.home - axis.min;
    const double max_travel = std::min(kMaxRangeShare * std::max(up, down), kMaxReach);
    return up >= down ? max_travel : -max_travel;
}

/// Moves back and forth over distances of all lengths: their times contain both the speed and the ramps.
std::string stroke_moves(const Axis& axis) {
    std::string text = fmt::format("(back and forth with {}: its acceleration and jerk)\n", axis.letter);
    const double reach = axis_reach(axis);
    for (const double share : {1.0, 0.3, 0.1, 0.03, 0.01}) {
        const double to = axis.home + share * reach;
        for (int i = 0; i < 3; ++i)
            text += fmt::format("G0 {0}{1:.3f}\nG0 {0}{2:.3f}\n", axis.letter, to, axis.home);
    }
    return text;
}

struct Plane {
    const Axis& x;
    const Axis& y;
    double size_mm;
};

/// Writes corners of all angles between lines of 20 mm at most.
std::string zigzag_moves(const Plane& plane) {
    std::string text = "(corners of all angles)\nG64\n";
    const double side = plane.size_mm / 5;
    for (const int angle : {10, 30, 60, 90, 120, 150, 170}) {
        const double turn = angle * std::numbers::pi / 180;
        text += fmt::format("G0 X{:.3f} Y{:.3f}\n", plane.x.home, plane.y.home);
        const double sx = std::copysign(1.0, axis_reach(plane.x)),
                     sy = std::copysign(1.0, axis_reach(plane.y));
        for (int i = 0; i < 4; ++i) {
            const double x = side, middle = 0.6 * side, y = side * std::abs(std::sin(turn / 2));
            text += fmt::format("G1 X{:.3f} Y{:.3f} F6000\nG1 X{:.3f} Y{:.3f}\n", plane.x.home + sx * middle,
                                plane.y.home + sy * y, plane.x.home + sx * x, plane.y.home);
        }
    }
    return text + "G61\n";
}

std::string circle_moves(const Plane& plane) {
    std::string text = "(curves)\n";
    const double sx = std::copysign(1.0, axis_reach(plane.x));
    for (const double share : {0.05, 0.1, 0.2}) {
        const double radius = share * plane.size_mm;
        text += fmt::format("G0 X{:.3f} Y{:.3f}\nG2 X{:.3f} Y{:.3f} I{:.3f} J0 F30000\n", plane.x.home,
                            plane.y.home, plane.x.home, plane.y.home, sx * radius);
    }
    return text;
}

std::string stop_moves(const Plane& plane) {
    std::string text = "(many stops)\nG61\n";
    const double sx = std::copysign(1.0, axis_reach(plane.x));
    for (int i = 0; i < 20; ++i) {
        text += fmt::format("G1 X{:.3f} F1000\nG4 P0.1\n",
                            plane.x.home + sx * 0.05 * plane.size_mm * (i % 2 == 0 ? 1 : 0));
    }
    return text;
}

/// Writes a word that takes the time of this key of [times], ten times between moves.
std::string word_moves(const std::string& key, const Plane& plane) {
    constexpr std::array<std::array<std::string_view, 2>, 8> kWords{{{"tool_change_s", "T1 M6"},
                                                                     {"tool_table_s", "G10 L1 P1 Z0"},
                                                                     {"coolant_on_s", "M8"},
                                                                     {"coolant_off_s", "M9"},
                                                                     {"spindle_start_s", "M3 S1000"},
                                                                     {"spindle_stop_s", "M5"},
                                                                     {"process_on_s", "M8"},
                                                                     {"process_off_s", "M9"}}};
    const auto* const found =
        std::find_if(kWords.begin(), kWords.end(), [&](const auto& each) { return each[0] == key; });
    const std::string_view word = found == kWords.end() ? std::string_view(key) : (*found)[1];
    std::string text = fmt::format("(time of {})\n", word);
    const double sx = std::copysign(1.0, axis_reach(plane.x));
    for (int i = 0; i < 10; ++i) {
        text += fmt::format("{}\nG1 X{:.3f} F1000\n", word,
                            plane.x.home + sx * 0.05 * plane.size_mm * (i % 2 == 0 ? 1 : 0));
    }
    return text;
}

std::optional<Plane> make_plane(const machine::Machine& machine) {
    const auto find = [&](char letter) {
        return std::find_if(machine.axes.begin(), machine.axes.end(),
                            [letter](const Axis& axis) { return axis.letter == letter; });
    };
    const auto x = find('X'), y = find('Y');
    if (x == machine.axes.end() || y == machine.axes.end()) return std::nullopt;
    return Plane{*x, *y, std::min(std::abs(axis_reach(*x)), std::abs(axis_reach(*y)))};
}

std::string controller_moves(const FittedParameter& parameter, const Plane& plane) {
    if (parameter.parameter_id.key == "centripetal_share") return circle_moves(plane);
    if (parameter.parameter_id.key == "settle_s" || parameter.parameter_id.key == "standstill_s")
        return stop_moves(plane);
    return zigzag_moves(plane);
}

}  // namespace

std::string test_program(const Fit& fit) {
    std::string text;
    const auto plane = make_plane(fit.machine);
    for (const FittedParameter& parameter : fit.parameters) {
        if (parameter.identified) continue;
        if (parameter.parameter_id.of == "path") {
            if (plane) text += zigzag_moves(*plane);
        } else if (parameter.parameter_id.of == "controller") {
            if (plane) text += controller_moves(parameter, *plane);
        } else if (parameter.parameter_id.of == "times") {
            if (plane) text += word_moves(parameter.parameter_id.key, *plane);
        } else {
            for (const Axis& axis : fit.machine.axes) {
                if (parameter.parameter_id.of.find(axis.letter) != std::string::npos)
                    text += stroke_moves(axis);
            }
        }
    }
    if (text.empty()) return text;
    return "(for gsim-calibrate: run it without a tool, and record how long it takes)\nG21 G90 G94 G17\n" +
           text + "M2\n";
}

}  // namespace gsim::calibrate
