#include "tests/accuracy/klipper_estimator.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace gsim::accuracy {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A straight move; squares of speeds are in mm2/s2.
struct Line {
    double length_mm = 0;
    Eigen::Vector3d direction{0, 0, 0};  ///< 0 of the extruder alone.
    double extruded = 0;                 ///< mm for each mm.
    double acceleration_mm_s2 = 0;
    double cruise_2 = 0;          ///< Max value.
    double entry_2 = 0;           ///< Max value, by the corner before.
    double gain_2 = 0;            ///< Gain by its acceleration over its length.
    double smoothed_entry_2 = 0;  ///< The same in the smoothed plan, with less acceleration.
    double smoothed_gain_2 = 0;
    double start_2 = 0, end_2 = 0;  ///< As planned, with what is reached in between.
    double reached_2 = 0;

    double time_s() const {
        const double start = std::sqrt(start_2), end = std::sqrt(end_2), reached = std::sqrt(reached_2);
        const double ramps_mm = (2 * reached_2 - start_2 - end_2) / 2 / acceleration_mm_s2;
        return (2 * reached - start - end) / acceleration_mm_s2 +
               std::max(length_mm - ramps_mm, 0.0) / reached;
    }
};

Line line_of(const ProgrammedMove& move, double length_mm, const Eigen::Vector3d& direction,
             const machine::Machine& machine) {
    Line line{length_mm, direction, move.extruded, move.acceleration};
    const double speed = std::min(move.feed_s, move.speed_limit);
    line.cruise_2 = speed * speed;
    line.gain_2 = 2 * length_mm * move.acceleration;
    const double beside_mm_s2 =
        machine.path.max_acceleration_mm_s2 * (1 - machine.controller.klipper.minimum_cruise_ratio);
    line.smoothed_gain_2 = std::min(2 * length_mm * beside_mm_s2, line.gain_2);
    return line;
}

/// Adds equal chords, as many as possible with at least the resolution as their length on the arc.
void add_chords(const ProgrammedMove& move, const machine::Machine& machine, std::vector<Line>& lines) {
    const double count =
        std::max(1.0, std::floor(move.length_mm / machine.controller.klipper.arc_resolution_mm));
    const double turn = move.sweep_rad / count;
    const double climb_mm = move.climb_mm / count;
    const double flat_mm = 2 * move.radius_mm * std::sin(turn / 2);
    const Eigen::Vector3d flat = (move.enters - move.enters.dot(move.normal) * move.normal).normalized();
    for (double i = 0; i < count; ++i) {
        const Eigen::AngleAxisd turned((i + 0.5) * turn * move.sense, move.normal);
        const Eigen::Vector3d displacement = flat_mm * (turned * flat) + climb_mm * move.normal;
        lines.push_back(line_of(move, displacement.norm(), displacement.normalized(), machine));
    }
}

std::vector<Line> lines_of(std::span<const ProgrammedMove> moves, const machine::Machine& machine) {
    std::vector<Line> lines;
    for (const ProgrammedMove& move : moves) {
        if (move.length <= 0) continue;
        if (move.radius_mm > 0) {
            add_chords(move, machine, lines);
        } else {
            lines.push_back(line_of(move, move.length, move.enters, machine));
        }
    }
    return lines;
}

/// Returns the squared speed at which the extruder's speed may jump by so much.
double of_extruder_2(const Line& before, const Line& line, double jump_mm_s) {
    const double change = std::abs(line.extruded - before.extruded);
    return change > 0 ? jump_mm_s * jump_mm_s / change / change : line.cruise_2;
}

double jump_of_extruder_mm_s(const machine::Machine& machine) {
    for (const machine::Axis& axis : machine.axes) {
        if (axis.letter == 'E') return axis.max_speed_step;
    }
    return kNoLimit;
}

/// Limits the entry speed by the deviation that the square corner velocity represents, and by the circle that
/// touches both lines within their halves.
void limit_at_corner(const Line& before, double deviation_mm, double jump_mm_s, Line& line) {
    constexpr double kStraightBack = 0.99999, kStraight = -0.999999;
    if (line.direction.isZero() || before.direction.isZero()) return;
    double cosine = -line.direction.dot(before.direction);
    if (cosine > kStraightBack) return;
    cosine = std::max(cosine, kStraight);
    const double sine = std::sqrt((1 - cosine) / 2);
    const double radius_mm = deviation_mm * sine / (1 - sine);
    const double tangent = sine / std::sqrt((1 + cosine) / 2);
    line.entry_2 = std::min({of_extruder_2(before, line, jump_mm_s), line.cruise_2, before.cruise_2,
                             before.entry_2 + before.gain_2});
    for (const Line* each : {&before, static_cast<const Line*>(&line)}) {
        line.entry_2 = std::min({line.entry_2, radius_mm * each->acceleration_mm_s2,
                                 each->length_mm * tangent * each->acceleration_mm_s2 / 2});
    }
    line.smoothed_entry_2 = std::min(line.entry_2, before.smoothed_entry_2 + before.smoothed_gain_2);
}

void set(Line& line, double start_2, double end_2, double reached_2) {
    line.start_2 = std::min(start_2, reached_2);
    line.end_2 = std::min(end_2, reached_2);
    line.reached_2 = reached_2;
}

/// Plans from the end to the start. Lines that only slow down in the smoothed plan wait for the peak before
/// them.
void plan(std::vector<Line>& lines) {
    struct Waiting {
        Line* line;
        double start_2, end_2;
    };
    std::vector<Waiting> waiting;
    double end_2 = 0, smoothed_end_2 = 0, peak_2 = 0;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        const double reachable_2 = end_2 + line->gain_2;
        const double smoothed_reachable_2 = smoothed_end_2 + line->smoothed_gain_2;
        const double start_2 = std::min(line->entry_2, reachable_2);
        const double smoothed_2 = std::min(line->smoothed_entry_2, smoothed_reachable_2);
        if (smoothed_2 >= smoothed_reachable_2) {
            waiting.push_back({&*line, start_2, end_2});
        } else {
            if (!waiting.empty() || smoothed_2 + line->smoothed_gain_2 > smoothed_end_2) {
                peak_2 = std::min(line->cruise_2, (smoothed_2 + smoothed_reachable_2) / 2);
                double most_2 = peak_2;
                for (auto next = waiting.rbegin(); next != waiting.rend(); ++next) {
                    most_2 = std::min(most_2, next->start_2);
                    set(*next->line, next->start_2, next->end_2, most_2);
                }
                waiting.clear();
            }
            set(*line, start_2, end_2, std::min({(start_2 + reachable_2) / 2, line->cruise_2, peak_2}));
        }
        end_2 = start_2;
        smoothed_end_2 = smoothed_2;
    }
}

}  // namespace

double klipper_estimator_s(std::span<const ProgrammedMove> moves, const machine::Machine& machine) {
    std::vector<Line> lines = lines_of(moves, machine);
    const double square_mm_s = machine.controller.klipper.square_corner_velocity_mm_s;
    const double deviation_mm =
        square_mm_s * square_mm_s * (std::numbers::sqrt2 - 1) / machine.path.max_acceleration_mm_s2;
    const double jump_mm_s = jump_of_extruder_mm_s(machine);
    for (std::size_t i = 1; i < lines.size(); ++i)
        limit_at_corner(lines[i - 1], deviation_mm, jump_mm_s, lines[i]);
    plan(lines);
    double time_s = 0;
    for (const ProgrammedMove& move : moves) time_s += move.wait_s;
    for (const Line& line : lines) time_s += line.time_s();
    return time_s;
}

}  // namespace gsim::accuracy
