#include "motion/path/lead_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/profile/rest_law.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kShortest_s = 1e-15;  // below, speeds are no physical values and may not even be finite

LimitedBy limit_of_move(const Segment& segment, const LeadPath& lead, const Followers* followers,
                        double lead_s) {
    if (segment.duration_s <= lead_s) {
        return limit_reached(segment.lead, lead.limits, lead.speed_limit, lead.acceleration_limit,
                             lead.jerk_limit);
    }
    const bool follower = followers != nullptr && segment.duration_s <= followers->fastest_s();
    return follower ? followers->slowest() : LimitedBy{LimitKind::time, -1};
}

}  // namespace

void limit_by_path(const MoveRules& rules, LeadPath& lead) {
    lead.limit_speed(rules.programmed_speed_mm_s, {LimitKind::feed, -1});
    lead.limit_speed(rules.max_path_speed_mm_s, {LimitKind::path_speed, -1});
    lead.limit_acceleration(rules.path_acceleration_mm_s2, {LimitKind::path_acceleration, -1});
    lead.limit_deceleration(rules.path_acceleration_mm_s2);
}

Planned set_timing(Segment& segment, const LeadPath& lead, const Followers* followers,
                   double least_duration_s) {
    const double lead_s = fastest_rest_s(lead.length, lead.limits);
    const double duration_s =
        std::max({lead_s, followers != nullptr ? followers->fastest_s() : 0.0, least_duration_s});
    if (!std::isfinite(lead.length) || !(duration_s <= kLongest_s)) {
        return refused(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The move is too long or too slow: it would take more than {} s.", kLongest_s));
    }
    if (duration_s < kShortest_s) {
        return refused(Status::RRS_ZERO_SPEED,
                       "The move would take no time: no speed is programmed and the machine sets no limit.");
    }
    segment.duration_s = duration_s;
    segment.lead = rest_law(lead.length, lead.limits, lead_s, duration_s);
    segment.lead_limits = lead.limits;
    if (followers != nullptr) followers->write(segment, duration_s);
    segment.limited_by = limit_of_move(segment, lead, followers, lead_s);
    return {};
}

Planned set_timing_with_beside(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                               JointRole role, LeadPath lead, Segment& segment) {
    const OrientationArc* const orientation = segment.orientation.get();
    if (rules.rapid_share < 1)
        lead.limit_speed(rules.rapid_share * lead.limits.max_speed, {LimitKind::rapid_override, -1});
    if (setup.controller.own_ramps) {
        const Followers followers(setup, rules, changes, role, orientation);
        return set_timing(segment, lead, &followers, rules.least_duration_s);
    }
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (!is_beside(changes, role, orientation, joint)) continue;
        lead.limit_by_joint(joint, limits_beside(setup, rules, changes, joint),
                            std::abs(changes.of(joint)) / lead.length);
    }
    return set_timing(segment, lead, nullptr, rules.least_duration_s);
}

}  // namespace gsim::motion
