#include "runtime/motion/followers.h"

#include <algorithm>
#include <cmath>

namespace gsim::motion {

Followers::Followers(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                     JointRole lead) {
    const double turn = changes.norm(JointRole::rotary);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = changes.of(joint);
        if (change == 0 || changes.role(joint) == lead) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        if (changes.role(joint) != JointRole::rotary) {
            add(joint, change, limits.max_speed, limits.max_acceleration);
            continue;
        }
        const double share = std::abs(change) / turn;
        add(joint, change, std::min(limits.max_speed, rules.orientation_speed_rad_s * share),
            std::min(limits.max_acceleration, rules.orientation_acceleration_rad_s2 * share));
    }
}

void Followers::add(int joint, double change, double max_speed, double max_acceleration) {
    const double fastest_s = TimeLaw::fastest_s(std::abs(change), max_speed, max_acceleration);
    moves_[count_++] = {joint, change, max_speed, max_acceleration, fastest_s};
    if (fastest_s <= fastest_s_) return;
    fastest_s_ = fastest_s;
    const bool reached = max_speed * max_speed <= std::abs(change) * max_acceleration;
    slowest_ = {reached ? LimitKind::joint_speed : LimitKind::acceleration, static_cast<std::int8_t>(joint)};
}

void Followers::write(Segment& segment, double duration_s) const {
    for (const Move& move : std::span(moves_.data(), count_)) {
        segment.add_follower(move.joint, std::copysign(1.0, move.change),
                             law_within(std::abs(move.change), move.max_speed, move.max_acceleration,
                                        move.fastest_s, duration_s));
    }
}

TimeLaw law_within(double length, double max_speed, double max_acceleration, double fastest_s,
                   double duration_s) {
    if (duration_s <= fastest_s) return TimeLaw::fastest(length, max_speed, max_acceleration);
    return TimeLaw::in_time(length, duration_s, max_acceleration, max_speed);
}

}  // namespace gsim::motion
