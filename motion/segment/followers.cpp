#include "motion/segment/followers.h"

#include <algorithm>
#include <cmath>

#include "motion/profile/rest_to_rest_law.h"

namespace gsim::motion {

Followers::Followers(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                     JointRole master, const OrientationArc* orientation) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (moves_outside_path(changes, master, orientation, joint))
            add(joint, changes.of(joint), other_joint_limits(setup, rules, changes, joint));
    }
}

void Followers::add(int joint, double change, const LawLimits& limits) {
    const double fastest_s = min_rest_to_rest_s(std::abs(change), limits);
    moves_[count_++] = {joint, change, limits, fastest_s};
    if (fastest_s <= fastest_s_) return;
    fastest_s_ = fastest_s;
    const auto index = static_cast<std::int8_t>(joint);
    slowest_ = reached_limit(rest_to_rest_law(std::abs(change), limits, fastest_s, fastest_s), limits,
                             {LimitKind::joint_speed, index}, {LimitKind::acceleration, index},
                             {LimitKind::jerk, index});
}

void Followers::write(Segment& segment, double duration_s) const {
    for (const Move& move : std::span(moves_.data(), count_)) {
        segment.add_follower(move.joint, std::copysign(1.0, move.change),
                             rest_to_rest_law(std::abs(move.change), move.limits, move.fastest_s, duration_s),
                             move.limits);
    }
}

bool moves_outside_path(const JointChanges& changes, JointRole master, const OrientationArc* orientation,
                        int joint) {
    if (changes.of(joint) == 0 || changes.role(joint) == master) return false;
    return orientation == nullptr || !orientation->moves(joint);
}

LawLimits other_joint_limits(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                             int joint) {
    LawLimits limits = law_limits(setup, joint);
    limits.max_speed *= rules.rapid_share;
    if (changes.role(joint) != JointRole::rotary) return limits;
    const double share = std::abs(changes.of(joint)) / changes.norm(JointRole::rotary);
    const double acceleration = rules.orientation_acceleration_rad_s2 * share;
    limits.max_speed = std::min(limits.max_speed, rules.orientation_speed_rad_s * share);
    limits.acceleration = std::min(limits.acceleration, acceleration);
    limits.deceleration = std::min(limits.deceleration, acceleration);
    return limits;
}

LawLimits law_limits(const PlannerSetup& setup, int joint) {
    const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
    return {limits.max_speed, limits.max_acceleration, limits.deceleration(),
            setup.controller.ramps.limit_jerk ? limits.max_jerk : kUnlimited};
}

LimitCause reached_limit(const TimeLaw& law, const LawLimits& limits, const LimitCause& speed_limit,
                         const LimitCause& acceleration_limit, const LimitCause& jerk_limit) {
    constexpr double kReachedShare = 1 - 1e-12;
    if (law.peak_speed() >= limits.max_speed * kReachedShare) return speed_limit;
    const double acceleration = std::min(limits.acceleration, limits.deceleration);
    const bool jerk = std::isfinite(limits.jerk) && law.peak_acceleration() < acceleration * kReachedShare;
    return jerk ? jerk_limit : acceleration_limit;
}

}  // namespace gsim::motion
