#include "motion/path/chords.h"

#include <algorithm>
#include <cmath>

#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

constexpr double kMaxChords = 1e7;

void set_chord_speed(const PathMove& move, const rrs::CurveRules& curves, int number_of_chords,
                     PathMove& line) {
    const double requested_s = move.rules.min_duration_s;
    if (requested_s <= 0) return;
    line.rules.min_duration_s = 0;
    // F in 1/min is 60 / requested_s. It is taken as mm/min if it counts once for each chord.
    line.rules.programmed_speed_mm_s =
        curves.inverse_time_per_chord ? number_of_chords / requested_s : move.arc.length_mm() / requested_s;
}

}  // namespace

int chord_count(const Arc& arc, const rrs::ControllerRules& controller) {
    if (controller.capabilities().arc_chords != rrs::ArcChords::by_length)
        return chord_count(arc, controller.curves.arc_chord_tolerance_mm);
    return static_cast<int>(
        std::clamp(std::floor(arc.length_mm() / controller.klipper.arc_resolution_mm), 1.0, kMaxChords));
}

int chord_count(const Arc& arc, double tolerance_mm) {
    const double radius = std::max(arc.radius_mm, tolerance_mm);
    const double count =
        std::floor(arc.sweep_rad * radius / 2 / std::sqrt(tolerance_mm * (2 * radius - tolerance_mm)));
    return static_cast<int>(std::clamp(count, 1.0, kMaxChords));
}

void for_each_chord(const PathMove& move, const PlannerSetup& setup,
                    const std::function<void(const PathMove&)>& on_part) {
    const int count = chord_count(move.arc, setup.controller);
    PathMove line = move;
    line.kind = SegmentKind::linear;
    set_chord_speed(move, setup.controller.curves, count, line);
    line.share = move.share / count;
    for (int i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        line.end = i == count ? move.end : rrs::JointPos(move.start + share * (move.end - move.start));
        if (i < count)
            write_position(setup.position_joints, move.arc.at(share * move.arc.sweep_rad), line.end);
        line.reaches_target = i == count;
        on_part(line);
        line.start = line.end;
    }
}

}  // namespace gsim::motion
