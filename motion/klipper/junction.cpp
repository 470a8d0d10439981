#include "motion/klipper/junction.h"

#include <algorithm>
#include <cmath>

#include "motion/path/axis_space.h"

namespace gsim::motion::klipper {

namespace {

/// A circle that touches both lines represents the corner. It misses the corner by the junction deviation,
/// and touches each line within half of its length.
double corner_speed_cap(const PlannerSetup& setup, const QueuedMove& before, const QueuedMove& move) {
    const double dot_product = read_position(setup, before.slope).dot(read_position(setup, move.slope));
    const double sine =
        std::sqrt(std::max((1 + dot_product) / 2, 0.0));  // of half the angle between the lines
    const double cosine = std::sqrt(std::max((1 - dot_product) / 2, 0.0));
    if (!(sine < 1 && cosine > 0)) return kUnlimited;
    const double radius = sine / (1 - sine);  // by the junction deviation
    const double touch = sine / cosine / 4;
    return std::min({radius * move.junction_deviation_mm * move.acceleration,
                     radius * before.junction_deviation_mm * before.acceleration, touch * move.full.change,
                     touch * before.full.change});
}

/// The flow out of a nozzle changes at once, so each extruder tolerates a jump of its speed.
double extruder_speed_cap(const PlannerSetup& setup, const QueuedMove& before, const QueuedMove& move) {
    double cap = kUnlimited;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (setup.role(joint) == JointRole::position) continue;
        const double change = std::abs(move.slope[joint] - before.slope[joint]);
        if (change == 0) continue;
        const double speed = setup.joints[static_cast<std::size_t>(joint)].max_speed_step / change;
        cap = std::min(cap, speed * speed);
    }
    return cap;
}

}  // namespace

void join(const PlannerSetup& setup, const QueuedMove& before, QueuedMove& move) {
    move.full.entry_cap_squared = move.smooth.entry_cap_squared = 0;
    if (!before.moves_tool || !move.moves_tool || before.stops) return;
    move.full.entry_cap_squared =
        std::min({move.max_speed_squared(), before.max_speed_squared(),
                  before.full.entry_cap_squared + before.full.change, corner_speed_cap(setup, before, move),
                  extruder_speed_cap(setup, before, move)});
    move.smooth.entry_cap_squared =
        std::min(move.full.entry_cap_squared, before.smooth.entry_cap_squared + before.smooth.change);
}

}  // namespace gsim::motion::klipper
