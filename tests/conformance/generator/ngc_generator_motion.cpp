// The part of the generator that writes motion.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/conformance/generator/ngc_generator.h"

namespace gsim::conformance {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

void NgcGenerator::straight() {
    const bool rapid = random_.chance(40);
    std::string words = std::string(rapid ? "G0" : "G1") + axis_words(40, incremental_);
    if (!rapid && inverse_time_) words += random_.word(" F", 1, 30);
    if (!rapid && !inverse_time_ && random_.chance(20)) words += random_.word(" F", 20, 900);
    line(words);
    motion_ = rapid || !inverse_time_ ? Motion::straight : Motion::other;
}

void NgcGenerator::modal_straight() {
    if (motion_ == Motion::straight) line(axis_words(30, incremental_).substr(1));
}

void NgcGenerator::polar() {
    if (plane_ != Plane::xy || incremental_ || inverse_time_) return;
    line(fmt::format("G{} @{} ^{}", random_.between(0, 1), random_.decimal(1, 30), value(180)));
    motion_ = Motion::straight;
}

void NgcGenerator::machine_move() {
    if (incremental_ || inverse_time_) return;
    line(fmt::format("G53 G{}{}", random_.between(0, 1), axis_words(40, false)));
    motion_ = Motion::straight;
}

/// Returns the words of an arc from the program's position: its end from there, and its centre.
std::string NgcGenerator::arc_words(bool absolute_centre) {
    const double radius = random_.between(20, 300) / 10.0;
    const double start = random_.between(0, 359) * kDegree;
    const double end = start + random_.between(10, 350) * kDegree;
    const double first = -radius * std::cos(start);
    const double second = -radius * std::sin(start);
    const double joints_to_first = first + radius * std::cos(end);
    const double joints_to_second = second + radius * std::sin(end);
    const std::string_view names = plane_ == Plane::xy ? "XYZIJ" : plane_ == Plane::zx ? "ZXYKI" : "YZXJK";
    const std::string_view parameters = plane_ == Plane::xy   ? "#5420#5421"
                                        : plane_ == Plane::zx ? "#5422#5420"
                                                              : "#5421#5422";
    const auto from_here = [&](double step, std::size_t axis, bool absolute) {
        return absolute ? fmt::format("[{} + {:.6f}]", parameters.substr(axis * 5, 5), step)
                        : fmt::format("{:.6f}", step);
    };
    const auto end_word = [&](double step, std::size_t axis) {
        const std::string at = from_here(step, axis, !incremental_);
        return fmt::format("{}{}", names[axis], diameters_ && names[axis] == 'X' ? "[2 * " + at + "]" : at);
    };
    std::string words = fmt::format("{} {}", end_word(joints_to_first, 0), end_word(joints_to_second, 1));
    words += fmt::format(" {}{} {}{}", names[3], from_here(first, 0, absolute_centre), names[4],
                         from_here(second, 1, absolute_centre));
    if (random_.chance(30)) words += fmt::format(" {}{}", names[2], random_.decimal(-5, 5));
    if (random_.chance(20)) words += fmt::format(" P{}", random_.between(1, 4));
    return words;
}

void NgcGenerator::arc() {
    if (rotated_ && plane_ != Plane::xy) return;
    const bool absolute_centre = random_.chance(15);
    if (absolute_centre) line("G90.1");
    line(fmt::format("G{} {}{}", random_.between(2, 3), arc_words(absolute_centre),
                     inverse_time_ ? random_.word(" F", 1, 30) : ""));
    if (absolute_centre) line("G91.1");
    motion_ = Motion::other;
}

void NgcGenerator::arc_by_radius() {
    if (rotated_ && plane_ != Plane::xy) return;
    const int reach = random_.between(4, 30);
    const std::string_view axes = plane_ == Plane::xy ? "XY" : plane_ == Plane::zx ? "ZX" : "YZ";
    if (!incremental_) line("G91");
    line(fmt::format("G{} {}{} {}{} R{}{}{}", random_.between(2, 3), axes[0], reach, axes[1],
                     random_.decimal(-5, 5), random_.chance(30) ? "-" : "", random_.decimal(reach, 2 * reach),
                     inverse_time_ ? " F12" : ""));
    if (!incremental_) line("G90");
    motion_ = Motion::other;
}

void NgcGenerator::full_circle() {
    if (rotated_ && plane_ != Plane::xy) return;
    const std::string_view centre = plane_ == Plane::xy ? "I" : plane_ == Plane::zx ? "K" : "J";
    line(fmt::format("G{} {}{}{}{}", random_.between(2, 3), centre, random_.decimal(1, 20),
                     random_.chance(30) ? fmt::format(" P{}", random_.between(1, 3)) : "",
                     inverse_time_ ? " F7" : ""));
    motion_ = Motion::other;
}

/// The end of a spline is not printed, so that a move to a known position follows.
void NgcGenerator::spline() {
    if (plane_ != Plane::xy || inverse_time_) return;
    const int splines = random_.between(1, 3);
    for (int i = 0; i < splines; ++i) {
        const std::string end =
            fmt::format("X{} Y{}", random_.decimal(5 + 40 * i, 40 + 40 * i), random_.decimal(-30, 30));
        if (random_.chance(50)) {
            line(fmt::format("G5 {} I{} J{} P{} Q{}", end, random_.decimal(-5, 5), random_.decimal(1, 5),
                             random_.decimal(-5, 5), random_.decimal(1, 5)));
        } else {
            line(fmt::format("G5.1 {} I{} J{}", end, random_.decimal(1, 5), random_.decimal(-5, 5)));
        }
    }
    back_to_known_place();
}

void NgcGenerator::nurbs() {
    if (plane_ != Plane::xy || inverse_time_ || incremental_) return;
    line(fmt::format("G5.2 X{} Y{} P1 L3", random_.decimal(1, 9), random_.decimal(1, 9)));
    for (int i = 0; i < 3; ++i) {
        line(fmt::format("X{} Y{} P{}", random_.decimal(10 * i + 10, 10 * i + 19), random_.decimal(-20, 20),
                         random_.decimal(1, 3)));
    }
    line("G5.3");
    back_to_known_place();
}

void NgcGenerator::cycle() {
    if (inverse_time_) return;
    const std::string_view depth_axis = plane_ == Plane::xy ? "Z" : plane_ == Plane::zx ? "Y" : "X";
    const std::string_view hole_axes = plane_ == Plane::xy ? "XY" : plane_ == Plane::zx ? "ZX" : "YZ";
    const std::string_view code = random_.one_of({"G81", "G82", "G83", "G73", "G85", "G89", "G86"});
    if (code == "G86" && !spindle_turns_) return;
    std::string words =
        fmt::format("{} {} {}{} {}{} {}{} R{}", random_.one_of({"G98", "G99"}), code, hole_axes[0], value(20),
                    hole_axes[1], value(20), depth_axis, random_.decimal(-20, -1), random_.decimal(1, 8));
    if (code == "G82" || code == "G89" || code == "G86") words += fmt::format(" P{}", random_.decimal(0, 2));
    if (code == "G83" || code == "G73") words += fmt::format(" Q{}", random_.decimal(1, 6));
    if (random_.chance(20)) words += fmt::format(" L{}", random_.between(1, 3));
    line(words);
    while (random_.chance(40)) more_holes();
    line("G80");
    motion_ = Motion::none;
}

void NgcGenerator::more_holes() {
    const std::string_view axes = plane_ == Plane::xy ? "XY" : plane_ == Plane::zx ? "ZX" : "YZ";
    line(fmt::format("{}{}{}", axes[random_.below(2)], value(20), random_.chance(20) ? " L2" : ""));
}

/// The next block names all axes, because the stand-alone interpreter is not where its probe has ended.
void NgcGenerator::probe() {
    if (inverse_time_ || per_turn_ || incremental_) return;
    line(fmt::format("G38.{} X{} Y{} Z{}", random_.between(2, 5), random_.decimal(41, 60), value(20),
                     random_.decimal(-30, 30)));
    back_to_known_place();
}

void NgcGenerator::back_to_known_place() {
    line(fmt::format("G90 G0 X{} Y{} Z{}", random_.decimal(-40, 40), random_.decimal(-40, 40),
                     random_.decimal(-20, 40)));
    if (incremental_) line("G91");
    motion_ = Motion::straight;
    unsure_ = false;
}

void NgcGenerator::thread() {
    if (!spindle_turns_ || inverse_time_) return;
    if (random_.chance(60)) {
        line(fmt::format("G33 X{} Z{} K{}", random_.decimal(-20, 20), random_.decimal(-40, -1),
                         random_.decimal(1, 3)));
    } else {
        line(fmt::format("G33.1 Z{} K{}", random_.decimal(-60, -41), random_.decimal(1, 3)));
    }
    motion_ = Motion::other;
}

void NgcGenerator::threading_cycle() {
    if (!spindle_turns_ || inverse_time_ || rotated_ || incremental_) return;
    line("G18");
    line("G0 X20 Z5");
    line(fmt::format("G76 P{} Z{} I-1 J{} R{} K2 Q{} H{} E{} L{}", random_.decimal(1, 3),
                     random_.decimal(-30, -10), random_.one_of({"0.5", "0.75"}),
                     random_.one_of({"1", "1.5", "2"}), random_.one_of({"0", "29.5"}), random_.between(0, 2),
                     random_.one_of({"0", "1.5"}), random_.between(0, 3)));
    line(plane_ == Plane::xy ? "G17" : plane_ == Plane::zx ? "G18" : "G19");
    motion_ = Motion::other;
}

void NgcGenerator::dwell() {
    line(fmt::format("G4 P{}", random_.decimal(0, 3)));
}

}  // namespace gsim::conformance
