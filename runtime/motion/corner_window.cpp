#include "runtime/motion/corner_window.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion/axis_space.h"
#include "runtime/motion/corner.h"

namespace gsim::motion {

namespace {

/// Corners in a row up to the newest one, which are passed at its speed v or at a lower one of their own.
/// Together they change the speeds of the joints by v turn + before, or by v whole_turn where v is below all
/// of the lower ones, too.
struct Stretch {
    rrs::JointPos turn;
    rrs::JointPos before;  ///< mm/s or rad/s
    rrs::JointPos whole_turn;
    double least = kUnlimited;  ///< The lowest speed of their own.
    double way = 0;             ///< That the corners count for.

    void add(const rrs::JointPos& change, double most, double speed) {
        whole_turn += change;
        if (most < speed) {
            before += most * change;
            least = std::min(least, most);
        } else {
            turn += change;
        }
    }
};

/// The way that is left of a block's where it is counted in the time that `speed` takes for it: on a long one
/// the motion speeds up from its corners and slows down again.
double way_at(const Block& block, double speed) {
    const double highest = std::sqrt(speed * speed + block.acceleration * block.lead.length);
    const double peak = std::min(highest, block.max_speed);
    return peak > speed ? block.lead.length * 2 * speed / (speed + peak) : block.lead.length;
}

/// Calls `look` with the stretches of two and more corners, from the shortest on, that are not longer than
/// `longest`. A corner at which the motion stops ends them. `speed` is what `look` leaves for the newest.
template <typename Look>
void for_each_stretch(const BlocksBefore& before, const Block& to, double longest, const double& speed,
                      const Look& look) {
    const rrs::JointPos newest = to.slope_in - before.back().slope_out;
    Stretch stretch{newest, rrs::JointPos::Zero(newest.size()), newest};
    double way = 0;
    double corners = 1;
    for (std::size_t i = before.size(); i-- > 1 && before[i].entry_cap > 0;) {
        const Block& block = before[i];
        way += way_at(block, speed);
        if (way > longest) return;
        stretch.add(block.slope_in - before[i - 1].slope_out, std::min(block.entry_cap, block.max_speed),
                    speed);
        if (block.move.kind == SegmentKind::circular)
            stretch.add(block.slope_out - block.slope_in, block.max_speed, speed);
        ++corners;
        stretch.way = way * corners / (corners - 1);
        look(stretch);
    }
}

double towards_center(const PlannerSetup& setup, int joint) {
    return std::min(setup.controller.centripetal_share, 1.0) *
           setup.joints[static_cast<std::size_t>(joint)].least_acceleration();
}

/// From this length on no turn of a joint, at most from -1 to 1, takes more than the joint's acceleration.
double longest_stretch(const PlannerSetup& setup, double speed) {
    double least = kUnlimited;
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        least = std::min(least, towards_center(setup, joint));
    return 2 * speed * speed / least;
}

/// The highest speed v at which a joint keeps to its step, v turn + before <= step, or to its acceleration,
/// v turn + before <= acceleration way / v.
double speed_of_joint(double step, double acceleration, double turn, double before, double way) {
    const double by_step = (step - before) / turn;
    const double root = std::sqrt(before * before + 4 * turn * acceleration * way);
    return std::max(by_step, (root - before) / (2 * turn));
}

double speed_by(const PlannerSetup& setup, const rrs::JointPos& turns, const rrs::JointPos& before,
                double way) {
    double speed = kUnlimited;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double turn = std::abs(turns[joint]);
        if (turn < kNoShare) continue;
        const double along = turns[joint] < 0 ? -before[joint] : before[joint];
        speed = std::min(
            speed, speed_of_joint(speed_step(setup, joint), towards_center(setup, joint), turn, along, way));
    }
    return speed;
}

double speed_on(const PlannerSetup& setup, const Stretch& stretch) {
    const double faster = speed_by(setup, stretch.turn, stretch.before, stretch.way);
    if (faster >= stretch.least || std::isinf(stretch.least)) return faster;
    const rrs::JointPos none = rrs::JointPos::Zero(setup.joint_count());
    return std::max(faster, std::min(stretch.least, speed_by(setup, stretch.whole_turn, none, stretch.way)));
}

/// What the corners take of the joints' accelerations where their steps do not cover them.
rrs::JointPos taken_by_corners(const PlannerSetup& setup, const BlocksBefore& before, const Block& to) {
    const double speed = std::min(to.entry_cap, to.max_speed);
    rrs::JointPos taken = rrs::JointPos::Zero(setup.joint_count());
    for_each_stretch(before, to, longest_stretch(setup, speed), speed, [&](const Stretch& stretch) {
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            const double change = std::abs(speed * stretch.turn[joint] + stretch.before[joint]);
            if (change > speed_step(setup, joint))
                taken[joint] = std::max(taken[joint], speed * change / stretch.way);
        }
    });
    return taken;
}

}  // namespace

double speed_in_window(const PlannerSetup& setup, const BlocksBefore& before, double most, const Block& to) {
    if (!std::isfinite(setup.controller.centripetal_share)) return most;
    double speed = most;
    for_each_stretch(before, to, longest_stretch(setup, most), speed,
                     [&](const Stretch& stretch) { speed = std::min(speed, speed_on(setup, stretch)); });
    return speed;
}

void leave_for_corners(const PlannerSetup& setup, const BlocksBefore& before, Block& to) {
    if (!std::isfinite(setup.controller.centripetal_share)) return;
    const double least = 1 - std::min(setup.controller.centripetal_share, 1.0);
    const rrs::JointPos taken = taken_by_corners(setup, before, to);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = std::abs(to.slope_in[joint]);
        if (taken[joint] <= 0 || share < kNoShare) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        const auto left = [&](double acceleration) {
            return std::max(acceleration - taken[joint], least * acceleration) / share;
        };
        to.acceleration = std::min(to.acceleration, left(limits.max_acceleration));
        to.deceleration = std::min(to.deceleration, left(limits.deceleration()));
    }
}

}  // namespace gsim::motion
