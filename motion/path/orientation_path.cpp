#include "motion/path/orientation_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kOrientationTolerance_rad = 1e-9;
constexpr double kBranchChange_rad = 0.1;  // smallest change to other joint values with the same direction

/// Bounds of the derivatives of a joint by the length of the leading path.
struct JointSlopes {
    int joint;
    double first;
    double second;
    double third;
};

std::array<JointSlopes, 2> make_joint_slopes(const OrientationArc& arc, double master_length) {
    const HeadBounds bounds = arc.bounds();
    const double turn = arc.length_rad() / master_length;
    const double turn_squared = turn * turn;
    const double turn_cubed = turn_squared * turn;
    return {{{arc.turn_joint(), bounds.first.turn * turn, bounds.second.turn * turn_squared,
              bounds.third.turn * turn_cubed},
             {arc.tilt_joint(), bounds.first.tilt * turn, bounds.second.tilt * turn_squared,
              bounds.third.tilt * turn_cubed}}};
}

double ramp_acceleration(const LawLimits& joint) {
    return std::min(joint.acceleration, joint.deceleration);
}

// The chain rule gives the joint's acceleration q' a + q'' v^2 and its jerk q' j + 3 q'' v a + q''' v^3, with
// the path s(t) of the leading law and the joint's angle q(s). The speed is kept so low that the curvature
// alone takes at most half of the acceleration and a quarter of the jerk. Ramps take so little that the mixed
// term takes another quarter. The remainder is for the law.
void limit_speed(const LawLimits& joint, const JointSlopes& slopes, MasterPath& master) {
    const auto index = static_cast<std::int8_t>(slopes.joint);
    master.limit_speed(joint.max_speed / slopes.first, {LimitKind::joint_speed, index});
    if (slopes.second > 0)
        master.limit_speed(std::sqrt(ramp_acceleration(joint) / (2 * slopes.second)),
                           {LimitKind::acceleration, index});
    if (slopes.third > 0)
        master.limit_speed(std::cbrt(joint.jerk / (4 * slopes.third)), {LimitKind::jerk, index});
}

void limit_acceleration(const LawLimits& joint, const JointSlopes& slopes, MasterPath& master) {
    const auto index = static_cast<std::int8_t>(slopes.joint);
    const double max_acceleration = ramp_acceleration(joint);
    const double speed = master.limits.max_speed;
    if (std::isfinite(max_acceleration)) {
        const double round = slopes.second > 0 ? slopes.second * speed * speed : 0;
        master.limit_acceleration((max_acceleration - round) / slopes.first,
                                  {LimitKind::acceleration, index});
        master.limit_deceleration((max_acceleration - round) / slopes.first);
    }
    if (std::isfinite(joint.jerk) && slopes.second > 0) {
        const double share = joint.jerk / (12 * slopes.second * speed);
        master.limit_acceleration(share, {LimitKind::jerk, index});
        master.limit_deceleration(share);
    }
}

void limit_jerk(const LawLimits& joint, const JointSlopes& slopes, MasterPath& master) {
    if (!std::isfinite(joint.jerk)) return;
    double remainder = joint.jerk;
    if (slopes.second > 0) {
        const double speed = master.limits.max_speed;
        const double acceleration = std::max(master.limits.acceleration, master.limits.deceleration);
        remainder -= speed * (3 * slopes.second * acceleration + slopes.third * speed * speed);
    }
    master.limit_jerk(remainder / slopes.first, {LimitKind::jerk, static_cast<std::int8_t>(slopes.joint)});
}

tl::unexpected<PlanError> orientation_path_error(OrientationError error,
                                                 const kinematics::TiltingHead& head) {
    const auto no_path_error = [](std::string message) {
        return make_plan_error(Status::RRS_NO_SOLUTION, std::move(message));
    };
    switch (error) {
        case OrientationError::opposite:
            return no_path_error(
                "The tool would turn to the opposite direction, for which the great circle is not unique; "
                "insert a target in between.");
        case OrientationError::same:
            return no_path_error(fmt::format(
                "The tool would keep its direction while joints {} and {} (counted from 0) turn, which is "
                "not possible on a great circle; make it a rapid move or turn by the joint angles.",
                head.turn_joint, head.tilt_joint));
        case OrientationError::at_pole:
            return no_path_error(fmt::format(
                "The tool is along the axis of joint {0} (counted from 0) at one end of the move, so that "
                "the great circle does not turn joint {0}; turn it to its value before or after.",
                head.turn_joint));
        case OrientationError::different_solution: break;
    }
    return no_path_error(fmt::format(
        "The great circle reaches this direction of the tool with other values of joints {} and {} (counted "
        "from 0), by a half turn or full turns; use these values or turn by the joint angles.",
        head.turn_joint, head.tilt_joint));
}

/// True if the joints change the direction too little for a path.
bool is_unchanged(const kinematics::TiltingHead& head, const rrs::JointPos& start, const rrs::JointPos& end,
                  double min) {
    return std::abs(end[head.turn_joint] - start[head.turn_joint]) <= min &&
           std::abs(end[head.tilt_joint] - start[head.tilt_joint]) <= min;
}

bool turns_at_pole(const kinematics::TiltingHead& head, const rrs::JointPos& start,
                   const rrs::JointPos& end) {
    const double tilt = start[head.tilt_joint] + head.tilt_at_zero_rad;
    return std::abs(end[head.tilt_joint] - start[head.tilt_joint]) <= kOrientationTolerance_rad &&
           std::abs(std::sin(tilt)) <= kOrientationTolerance_rad;
}

}  // namespace

std::optional<std::string> find_great_circle_error(const PlannerSetup& setup) {
    if (!setup.controller.has_great_circles())
        return "This controller plans lines of joint values; it turns the tool by the joint angles.";
    if (!setup.kinematics->tilting_head()) {
        return "This machine has no head with a turning and a tilting joint through its TCP; it turns the "
               "tool by the joint angles.";
    }
    return std::nullopt;
}

tl::expected<std::shared_ptr<const OrientationArc>, PlanError> orientation_between(const PlannerSetup& setup,
                                                                                   const rrs::JointPos& start,
                                                                                   const rrs::JointPos& end) {
    const auto head = setup.kinematics->tilting_head();
    if (!head || is_unchanged(*head, start, end, kOrientationTolerance_rad) ||
        turns_at_pole(*head, start, end))
        return nullptr;
    const auto arc = OrientationArc::between(*head, start, end);
    if (!arc && arc.error() == OrientationError::same && is_unchanged(*head, start, end, kBranchChange_rad))
        return nullptr;
    if (!arc) return orientation_path_error(arc.error(), *head);
    if (PlanResult checked = check_tilt_range(setup, *arc); !checked)
        return tl::unexpected(std::move(checked.error()));
    return std::make_shared<const OrientationArc>(*arc);
}

void limit_by_head(const PlannerSetup& setup, const OrientationArc& arc, MasterPath& master) {
    const auto slopes = make_joint_slopes(arc, master.length);
    for (const auto limit : {limit_speed, limit_acceleration, limit_jerk}) {
        for (const JointSlopes& joint_slopes_item : slopes) {
            if (joint_slopes_item.first > 0)
                limit(law_limits(setup, joint_slopes_item.joint), joint_slopes_item, master);
        }
    }
}

void limit_by_orientation(const PlannerSetup& setup, const MoveRules& rules, const OrientationArc& arc,
                          MasterPath& master) {
    const double distance_per_rad = master.length / arc.length_rad();
    master.limit_speed(rules.orientation_speed_rad_s * distance_per_rad, {LimitKind::feed, -1});
    const double acceleration = rules.orientation_acceleration_rad_s2 * distance_per_rad;
    master.limit_acceleration(acceleration, {LimitKind::path_acceleration, -1});
    master.limit_deceleration(acceleration);
    limit_by_head(setup, arc, master);
}

}  // namespace gsim::motion
