#include "machine/model/machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "machine/model/frame_pose.h"
#include "motion/kinematics/chain_kinematics.h"
#include "motion/kinematics/gantry.h"
#include "motion/kinematics/numeric_kinematics.h"

namespace gsim::machine {

namespace {
constexpr double kTurn_deg = 360;
constexpr double kTurnTolerance = 1e-9;  // of a turn

// The joint follows a turn that is reversed after it, so frames on both sides are aligned.
kinematics::Link directed_link(const Axis& axis, int joint, rrs::JointKind kind) {
    const bool work = axis.carries == CarriedPart::work;
    const rrs::CartPos turn = rotation_to(work ? opposite(*axis.direction) : *axis.direction);
    const rrs::CartPos pose = axis.frame ? frame_pose(*axis.frame) : rrs::CartPos::Identity();
    return {.joint = joint, .kind = kind, .before = pose * turn, .after = turn.inverse()};
}

kinematics::Link link(const Axis& axis, int joint) {
    const auto kind = axis.kind == AxisKind::linear ? rrs::JointKind::prismatic : rrs::JointKind::revolute;
    if (axis.direction) return directed_link(axis, joint, kind);
    kinematics::Link dh_link = kinematics::make_link(joint, {.kind = kind,
                                                             .theta_rad = axis.dh.theta_deg * kRadPerDeg,
                                                             .d_mm = axis.dh.d_mm,
                                                             .a_mm = axis.dh.a_mm,
                                                             .alpha_rad = axis.dh.alpha_deg * kRadPerDeg});
    if (!axis.frame) return dh_link;
    return {.joint = joint, .kind = kind, .before = frame_pose(*axis.frame), .after = dh_link.after};
}

kinematics::Chain chain(const Machine& machine) {
    kinematics::Branch tool{.base = frame_pose(machine.base), .end = frame_pose(machine.tool)};
    kinematics::Branch work{.end = frame_pose(machine.work)};
    std::vector<int> unlinked_joints;
    int joint = 0;
    for (const Axis& axis : machine.axes) {
        if (axis.carries == CarriedPart::none) {
            unlinked_joints.push_back(joint++);
        } else {
            (axis.carries == CarriedPart::work ? work : tool).links.push_back(link(axis, joint++));
        }
    }
    return kinematics::Chain(std::move(tool), std::move(work), std::move(unlinked_joints));
}

std::vector<kinematics::JointRange> ranges(const Machine& machine) {
    std::vector<kinematics::JointRange> list;
    list.reserve(machine.axes.size());
    for (const Axis& axis : machine.axes)
        list.push_back({.min = joint_value(axis, axis.min),
                        .max = joint_value(axis, axis.max),
                        .name = std::string(1, axis.letter)});
    return list;
}

// Returns the joints that the inverse does not change.
std::vector<int> fixed_joints(const Machine& machine) {
    std::vector<int> joints;
    for (const AxisGroup& group : machine.groups) {
        for (const std::size_t axis : group.axes) joints.push_back(static_cast<int>(axis));
    }
    return joints;
}

using KinematicsResult = Result<std::shared_ptr<const kinematics::Kinematics>>;

KinematicsResult make(const Machine& machine) {
    switch (machine.inverse) {
        case InverseKind::gantry: return kinematics::GantryKinematics::make(chain(machine), ranges(machine));
        case InverseKind::numeric:
            return kinematics::NumericKinematics::make(chain(machine), ranges(machine),
                                                       fixed_joints(machine));
        case InverseKind::none: break;
    }
    return std::make_shared<kinematics::ChainKinematics>(chain(machine));
}

// Returns the smallest angle that is not below `min` and differs from `angle` by full turns.
double raise_by_full_turns(double angle, double min) {
    return angle + kTurn_deg * std::ceil((min - angle) / kTurn_deg);
}

double shortest_target(const Axis& axis, double value, double now, double origin) {
    const double difference = std::remainder(value - now, kTurn_deg);
    const double closest = now + (difference == -kTurn_deg / 2 ? -difference : difference);
    const double min = axis.min - origin;
    const double max = axis.max - origin;
    if (closest < min && raise_by_full_turns(closest, min) <= max) return raise_by_full_turns(closest, min);
    if (closest > max && -raise_by_full_turns(-closest, -max) >= min)
        return -raise_by_full_turns(-closest, -max);
    return closest;
}

// A reading that rounding has left just below a full turn counts as that turn.
double full_turns(double angle_deg) {
    return std::floor(angle_deg / kTurn_deg + kTurnTolerance);
}

}  // namespace

std::optional<std::size_t> Machine::find(char letter) const {
    const auto axis =
        std::find_if(axes.begin(), axes.end(), [letter](const Axis& a) { return a.letter == letter; });
    if (axis == axes.end()) return std::nullopt;
    return static_cast<std::size_t>(axis - axes.begin());
}

double axis_value(const Axis& axis, double joint_value) {
    return axis.zero + (axis.kind == AxisKind::linear ? joint_value : joint_value / kRadPerDeg);
}

double joint_value(const Axis& axis, double axis_value) {
    return (axis_value - axis.zero) * (axis.kind == AxisKind::linear ? 1 : kRadPerDeg);
}

rrs::JointPos home_position(const Machine& machine) {
    rrs::JointPos joints(static_cast<Eigen::Index>(machine.axes.size()));
    Eigen::Index joint = 0;
    for (const Axis& axis : machine.axes) joints[joint++] = joint_value(axis, axis.home);
    return joints;
}

std::optional<Error> find_kinematic_error(const Machine& machine) {
    if (machine.axes.size() > static_cast<std::size_t>(rrs::kMaxJoints)) {
        return "A machine has at most " + std::to_string(rrs::kMaxJoints) + " axes.";
    }
    if (auto result = make(machine); !result) return std::move(result.error().message);
    return std::nullopt;
}

std::optional<Error> find_controller_error(const Machine& machine) {
    const rrs::PlannerCapabilities& planner = machine.controller.capabilities();
    if (machine.controller.coordination.independent_ramps && !planner.plans_uncoordinated_joints)
        return "'independent_ramps' needs the planner \"rest-to-rest\": in the others all axes move in "
               "proportion";
    if (!machine.controller.coordination.interpolated_rapids && !planner.plans_uncoordinated_joints)
        return "'interpolated_rapids = false' needs the planner \"rest-to-rest\": in the others all axes "
               "move in proportion";
    if (!machine.controller.coordination.interpolated_rapids && std::isfinite(machine.path.max_rapid_mm_s))
        return "'interpolated_rapids = false' cannot be combined with 'max_rapid_mm_s': each axis has its "
               "own speed, so the tool speed is not limited";
    const bool uses_chords = planner.arc_chords == rrs::ArcChords::by_tolerance &&
                             machine.controller.curves.arc_chord_tolerance_mm > 0;
    if (machine.controller.blocks.path_measure == rrs::PathMeasure::all_axes && !uses_chords)
        return "'path_measure = \"all-axes\"' needs the planner \"look-ahead\" with arcs as chords "
               "(arc_chord_tolerance_mm), which plans only lines";
    if (machine.controller.ramps.limit_jerk && machine.controller.ramps.step_s > 0 && !uses_chords)
        return "'ramp_step_s' needs the planner \"look-ahead\" with arcs as chords (arc_chord_tolerance_mm), "
               "which plans only lines";
    if (machine.controller.coordination.orientation == rrs::OrientationRule::joints) return std::nullopt;
    if (!machine.controller.has_great_circles()) {
        return fmt::format(
            "'orientation = \"great-circle\"' cannot be combined with the planners {} or with arcs as "
            "chords: all of "
            "these plan lines of axis values",
            rrs::planners_without(&rrs::PlannerCapabilities::plans_great_circles));
    }
    if (make_kinematics(machine)->tilting_head()) return std::nullopt;
    return "'orientation = \"great-circle\"' needs 'inverse = \"gantry\"' and two rotary axes through the "
           "TCP at right angles, the second also at a right angle to the tool";
}

std::shared_ptr<const kinematics::Kinematics> make_kinematics(const Machine& machine) {
    auto result = make(machine);
    if (!result) throw std::invalid_argument(result.error().message);
    return *std::move(result);
}

double rotary_target(const Axis& axis, double value, double now, double origin) {
    if (axis.kind == AxisKind::linear || !std::isfinite(now)) return value;
    switch (axis.turning) {
        case RotaryMode::shortest: return shortest_target(axis, value, now, origin);
        case RotaryMode::unwind: return value + kTurn_deg * full_turns(now + origin);
        case RotaryMode::limited: break;
    }
    return value;
}

double reading(const Axis& axis, double value) {
    if (axis.kind == AxisKind::linear || axis.turning != RotaryMode::unwind || !std::isfinite(value))
        return value;
    return value - kTurn_deg * full_turns(value);
}

}  // namespace gsim::machine
