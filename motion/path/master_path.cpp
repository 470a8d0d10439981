#include "motion/path/master_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/profile/rest_to_rest_law.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kShortest_s = 1e-15;  // below, speeds are no physical values and may not even be finite

LimitCause limit_cause_of_move(const Segment& segment, const MasterPath& master, const Followers* followers,
                               double master_s) {
    if (segment.duration_s <= master_s) {
        return reached_limit(segment.master, master.limits, master.speed_limit, master.acceleration_limit,
                             master.jerk_limit);
    }
    const bool follower = followers != nullptr && segment.duration_s <= followers->fastest_s();
    return follower ? followers->slowest() : LimitCause{LimitKind::time, -1};
}

}  // namespace

void limit_by_path(const MoveRules& rules, MasterPath& master) {
    master.limit_speed(rules.programmed_speed_mm_s, {LimitKind::feed, -1});
    master.limit_speed(rules.max_path_speed_mm_s, {LimitKind::path_speed, -1});
    master.limit_acceleration(rules.path_acceleration_mm_s2, {LimitKind::path_acceleration, -1});
    master.limit_deceleration(rules.path_acceleration_mm_s2);
}

PlanResult set_timing(Segment& segment, const MasterPath& master, const Followers* followers,
                      double min_duration_s) {
    const double master_s = min_rest_to_rest_s(master.length, master.limits);
    const double duration_s =
        std::max({master_s, followers != nullptr ? followers->fastest_s() : 0.0, min_duration_s});
    if (!std::isfinite(master.length) || !(duration_s <= kMaxDuration_s)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The move is too long or too slow: it would take more than {} s.", kMaxDuration_s));
    }
    if (duration_s < kShortest_s) {
        return make_plan_error(
            Status::RRS_ZERO_SPEED,
            "The move would take no time: no speed is programmed and the machine has no limit.");
    }
    segment.duration_s = duration_s;
    segment.master = rest_to_rest_law(master.length, master.limits, master_s, duration_s);
    segment.master_limits = master.limits;
    if (followers != nullptr) followers->write(segment, duration_s);
    segment.limited_by = limit_cause_of_move(segment, master, followers, master_s);
    return {};
}

PlanResult set_timing_with_other_joints(const PlannerSetup& setup, const MoveRules& rules,
                                        const JointChanges& changes, JointRole role, MasterPath master,
                                        Segment& segment) {
    const OrientationArc* const orientation = segment.orientation.get();
    if (rules.rapid_share < 1)
        master.limit_speed(rules.rapid_share * master.limits.max_speed, {LimitKind::rapid_override, -1});
    if (setup.controller.coordination.independent_ramps) {
        const Followers followers(setup, rules, changes, role, orientation);
        return set_timing(segment, master, &followers, rules.min_duration_s);
    }
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (!moves_outside_path(changes, role, orientation, joint)) continue;
        master.limit_by_joint(joint, other_joint_limits(setup, rules, changes, joint),
                              std::abs(changes.of(joint)) / master.length);
    }
    return set_timing(segment, master, nullptr, rules.min_duration_s);
}

}  // namespace gsim::motion
