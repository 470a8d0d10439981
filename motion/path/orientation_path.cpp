#include "motion/path/orientation_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kNoChange_rad = 1e-9;
constexpr double kOtherBranch_rad = 0.1;  // smallest change to other joint values with the same direction

/// Bounds of the derivatives of a joint by the length of the leading path.
struct JointSlopes {
    int joint;
    double first;
    double second;
    double third;
};

std::array<JointSlopes, 2> joint_slopes_of(const OrientationArc& arc, double lead_length) {
    const HeadBounds bounds = arc.bounds();
    const double turn = arc.length_rad() / lead_length;
    const double turn2 = turn * turn;
    const double turn3 = turn2 * turn;
    return {
        {{arc.turn_joint(), bounds.first.turn * turn, bounds.second.turn * turn2, bounds.third.turn * turn3},
         {arc.tilt_joint(), bounds.first.tilt * turn, bounds.second.tilt * turn2,
          bounds.third.tilt * turn3}}};
}

double acceleration_of(const LawLimits& joint) {
    return std::min(joint.acceleration, joint.deceleration);
}

// The chain rule gives the joint's acceleration q' a + q'' v^2 and its jerk q' j + 3 q'' v a + q''' v^3, with
// the path s(t) of the leading law and the joint's angle q(s). The speed is kept so low that the curvature
// alone takes at most half of the acceleration and a quarter of the jerk. Ramps take so little that the mixed
// term takes another quarter. The remainder is for the law.
void limit_speed(const LawLimits& joint, const JointSlopes& slopes, LeadPath& lead) {
    const auto index = static_cast<std::int8_t>(slopes.joint);
    lead.limit_speed(joint.max_speed / slopes.first, {LimitKind::joint_speed, index});
    if (slopes.second > 0)
        lead.limit_speed(std::sqrt(acceleration_of(joint) / (2 * slopes.second)),
                         {LimitKind::acceleration, index});
    if (slopes.third > 0)
        lead.limit_speed(std::cbrt(joint.jerk / (4 * slopes.third)), {LimitKind::jerk, index});
}

void limit_acceleration(const LawLimits& joint, const JointSlopes& slopes, LeadPath& lead) {
    const auto index = static_cast<std::int8_t>(slopes.joint);
    const double most = acceleration_of(joint);
    const double speed = lead.limits.max_speed;
    if (std::isfinite(most)) {
        const double round = slopes.second > 0 ? slopes.second * speed * speed : 0;
        lead.limit_acceleration((most - round) / slopes.first, {LimitKind::acceleration, index});
        lead.limit_deceleration((most - round) / slopes.first);
    }
    if (std::isfinite(joint.jerk) && slopes.second > 0) {
        const double share = joint.jerk / (12 * slopes.second * speed);
        lead.limit_acceleration(share, {LimitKind::jerk, index});
        lead.limit_deceleration(share);
    }
}

void limit_jerk(const LawLimits& joint, const JointSlopes& slopes, LeadPath& lead) {
    if (!std::isfinite(joint.jerk)) return;
    double rest = joint.jerk;
    if (slopes.second > 0) {
        const double speed = lead.limits.max_speed;
        const double acceleration = std::max(lead.limits.acceleration, lead.limits.deceleration);
        rest -= speed * (3 * slopes.second * acceleration + slopes.third * speed * speed);
    }
    lead.limit_jerk(rest / slopes.first, {LimitKind::jerk, static_cast<std::int8_t>(slopes.joint)});
}

tl::unexpected<PlanError> refused_by(OrientationFault fault, const kinematics::TiltingHead& head) {
    const auto no_way = [](std::string message) {
        return refused(Status::RRS_NO_SOLUTION, std::move(message));
    };
    switch (fault) {
        case OrientationFault::opposite:
            return no_way(
                "The tool would turn to the opposite direction, to which no great circle is the "
                "only one; put a target in between.");
        case OrientationFault::same:
            return no_way(fmt::format(
                "The tool would keep its direction while joints {} and {} (counted from 0) turn, which no "
                "great circle leads to; make it a rapid move or turn by the joint angles.",
                head.turn_joint, head.tilt_joint));
        case OrientationFault::at_pole:
            return no_way(fmt::format(
                "The tool stands along the axis of joint {0} (counted from 0) at one end of the move, so "
                "that the great circle keeps joint {0} where it is; turn it to its value before or after.",
                head.turn_joint));
        case OrientationFault::other_end: break;
    }
    return no_way(fmt::format(
        "The great circle leads to this direction of the tool with other values of joints {} and {} (counted "
        "from 0), by a half turn or whole turns; take these values or turn by the joint angles.",
        head.turn_joint, head.tilt_joint));
}

/// True if the joints change the direction too little for a path.
bool stays(const kinematics::TiltingHead& head, const rrs::JointPos& start, const rrs::JointPos& end,
           double least) {
    return std::abs(end[head.turn_joint] - start[head.turn_joint]) <= least &&
           std::abs(end[head.tilt_joint] - start[head.tilt_joint]) <= least;
}

bool turns_at_pole(const kinematics::TiltingHead& head, const rrs::JointPos& start,
                   const rrs::JointPos& end) {
    const double tilt = start[head.tilt_joint] + head.tilt_at_zero_rad;
    return std::abs(end[head.tilt_joint] - start[head.tilt_joint]) <= kNoChange_rad &&
           std::abs(std::sin(tilt)) <= kNoChange_rad;
}

}  // namespace

std::optional<std::string> no_great_circles(const PlannerSetup& setup) {
    if (!setup.controller.has_great_circles())
        return "This controller plans lines of joint values; it turns the tool by the joint angles.";
    if (!setup.kinematics->tilting_head()) {
        return "This machine has no head of a turning and a tilting joint through the tip of its tool; it "
               "turns the tool by the joint angles.";
    }
    return std::nullopt;
}

tl::expected<std::shared_ptr<const OrientationArc>, PlanError> orientation_between(const PlannerSetup& setup,
                                                                                   const rrs::JointPos& start,
                                                                                   const rrs::JointPos& end) {
    const auto head = setup.kinematics->tilting_head();
    if (!head || stays(*head, start, end, kNoChange_rad) || turns_at_pole(*head, start, end)) return nullptr;
    const auto arc = OrientationArc::between(*head, start, end);
    if (!arc && arc.error() == OrientationFault::same && stays(*head, start, end, kOtherBranch_rad))
        return nullptr;
    if (!arc) return refused_by(arc.error(), *head);
    if (Planned checked = check_tilt_range(setup, *arc); !checked)
        return tl::unexpected(std::move(checked.error()));
    return std::make_shared<const OrientationArc>(*arc);
}

void limit_by_head(const PlannerSetup& setup, const OrientationArc& arc, LeadPath& lead) {
    const auto slopes = joint_slopes_of(arc, lead.length);
    for (const auto limit : {limit_speed, limit_acceleration, limit_jerk}) {
        for (const JointSlopes& of_joint : slopes) {
            if (of_joint.first > 0) limit(law_limits(setup, of_joint.joint), of_joint, lead);
        }
    }
}

void limit_by_orientation(const PlannerSetup& setup, const MoveRules& rules, const OrientationArc& arc,
                          LeadPath& lead) {
    const double way_per_turn = lead.length / arc.length_rad();
    lead.limit_speed(rules.orientation_speed_rad_s * way_per_turn, {LimitKind::feed, -1});
    const double acceleration = rules.orientation_acceleration_rad_s2 * way_per_turn;
    lead.limit_acceleration(acceleration, {LimitKind::path_acceleration, -1});
    lead.limit_deceleration(acceleration);
    limit_by_head(setup, arc, lead);
}

}  // namespace gsim::motion
