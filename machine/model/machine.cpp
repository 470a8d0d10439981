#include "machine/model/machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "base/units.h"
#include "machine/model/frame_pose.h"
#include "motion/kinematics/chain_kinematics.h"
#include "motion/kinematics/gantry.h"
#include "motion/kinematics/numeric.h"

namespace gsim::machine {

namespace {
constexpr double kTurn_deg = 360;
constexpr double kTurnTolerance = 1e-9;  // of a turn

// The joint follows a turn that is reversed after it, so frames on both sides are aligned.
kinematics::Link directed_link(const Axis& axis, int joint, rrs::JointKind kind) {
    const bool work = axis.carries == Carries::work;
    const rrs::CartPos turn = turned_to(work ? opposite(*axis.direction) : *axis.direction);
    const rrs::CartPos place = axis.frame ? frame_pose(*axis.frame) : rrs::CartPos::Identity();
    return {.joint = joint, .kind = kind, .before = place * turn, .after = turn.inverse()};
}

kinematics::Link link(const Axis& axis, int joint) {
    const auto kind = axis.kind == AxisKind::linear ? rrs::JointKind::prismatic : rrs::JointKind::revolute;
    if (axis.direction) return directed_link(axis, joint, kind);
    kinematics::Link by_row = kinematics::link_of(joint, {.kind = kind,
                                                          .theta_rad = axis.dh.theta_deg * kRadPerDeg,
                                                          .d_mm = axis.dh.d_mm,
                                                          .a_mm = axis.dh.a_mm,
                                                          .alpha_rad = axis.dh.alpha_deg * kRadPerDeg});
    if (!axis.frame) return by_row;
    return {.joint = joint, .kind = kind, .before = frame_pose(*axis.frame), .after = by_row.after};
}

kinematics::Chain chain(const Machine& machine) {
    kinematics::Branch tool{.base = frame_pose(machine.base), .end = frame_pose(machine.tool)};
    kinematics::Branch work{.end = frame_pose(machine.work)};
    std::vector<int> idle;
    int joint = 0;
    for (const Axis& axis : machine.axes) {
        if (axis.carries == Carries::nothing) {
            idle.push_back(joint++);
        } else {
            (axis.carries == Carries::work ? work : tool).links.push_back(link(axis, joint++));
        }
    }
    return kinematics::Chain(std::move(tool), std::move(work), std::move(idle));
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
std::vector<int> held_joints(const Machine& machine) {
    std::vector<int> joints;
    for (const AxisGroup& group : machine.groups) {
        for (const std::size_t axis : group.axes) joints.push_back(static_cast<int>(axis));
    }
    return joints;
}

using Made = tl::expected<std::shared_ptr<const kinematics::Kinematics>, std::string>;

Made make(const Machine& machine) {
    switch (machine.inverse) {
        case InverseKind::gantry: return kinematics::GantryKinematics::make(chain(machine), ranges(machine));
        case InverseKind::numeric:
            return kinematics::NumericKinematics::make(chain(machine), ranges(machine), held_joints(machine));
        case InverseKind::none: break;
    }
    return std::make_shared<kinematics::ChainKinematics>(chain(machine));
}

// Returns the smallest angle that is not below `least` and differs from `angle` by full turns.
double raised_to(double angle, double least) {
    return angle + kTurn_deg * std::ceil((least - angle) / kTurn_deg);
}

double shortest_target(const Axis& axis, double value, double now, double origin) {
    const double way = std::remainder(value - now, kTurn_deg);
    const double closest = now + (way == -kTurn_deg / 2 ? -way : way);
    const double min = axis.min - origin;
    const double max = axis.max - origin;
    if (closest < min && raised_to(closest, min) <= max) return raised_to(closest, min);
    if (closest > max && -raised_to(-closest, -max) >= min) return -raised_to(-closest, -max);
    return closest;
}

// A reading that rounding has left just below a full turn counts as that turn.
double whole_turns(double angle_deg) {
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

std::optional<std::string> find_kinematic_fault(const Machine& machine) {
    if (machine.axes.size() > static_cast<std::size_t>(rrs::kMaxJoints)) {
        return "A machine has at most " + std::to_string(rrs::kMaxJoints) + " axes.";
    }
    if (auto made = make(machine); !made) return std::move(made.error());
    return std::nullopt;
}

std::optional<std::string> find_controller_fault(const Machine& machine) {
    const bool rests = machine.controller.planner == rrs::PlannerKind::rest_to_rest;
    if (machine.controller.own_ramps && !rests)
        return "'own_ramps' is of the planner \"rest-to-rest\" alone: in the others all axes go in "
               "proportion";
    if (!machine.controller.interpolated_rapids && !rests)
        return "'interpolated_rapids = false' is of the planner \"rest-to-rest\" alone: in the others all "
               "axes go in proportion";
    if (!machine.controller.interpolated_rapids && std::isfinite(machine.path.max_rapid_mm_s))
        return "'interpolated_rapids = false' does not go with 'max_rapid_mm_s': each axis has its own "
               "speed, "
               "and nothing keeps that of the tool";
    const bool chords = machine.controller.planner == rrs::PlannerKind::look_ahead &&
                        machine.controller.arc_chord_tolerance_mm > 0;
    if (machine.controller.path_measure == rrs::PathMeasure::all_axes && !chords)
        return "'path_measure = \"all-axes\"' is of the planner \"look-ahead\" with arcs as chords alone "
               "(arc_chord_tolerance_mm): it plans lines";
    if (machine.controller.limit_jerk && machine.controller.ramp_step_s > 0 && !chords)
        return "'ramp_step_s' is of the planner \"look-ahead\" with arcs as chords alone "
               "(arc_chord_tolerance_mm): it drives lines";
    if (machine.controller.orientation == rrs::OrientationRule::joints) return std::nullopt;
    if (!machine.controller.has_great_circles()) {
        return "'orientation = \"great-circle\"' is not for the planners \"linuxcnc\" and \"klipper\" nor "
               "for arcs "
               "as chords: all of these plan lines of axis values";
    }
    if (make_kinematics(machine)->tilting_head()) return std::nullopt;
    return "'orientation = \"great-circle\"' needs 'inverse = \"gantry\"' and two rotary axes through the "
           "tip at "
           "right angles, the second one also to the tool";
}

std::shared_ptr<const kinematics::Kinematics> make_kinematics(const Machine& machine) {
    auto made = make(machine);
    if (!made) throw std::invalid_argument(made.error());
    return *std::move(made);
}

double turned_target(const Axis& axis, double value, double now, double origin) {
    if (axis.kind == AxisKind::linear || !std::isfinite(now)) return value;
    switch (axis.turning) {
        case Turning::shortest: return shortest_target(axis, value, now, origin);
        case Turning::unwind: return value + kTurn_deg * whole_turns(now + origin);
        case Turning::limited: break;
    }
    return value;
}

double reading(const Axis& axis, double value) {
    if (axis.kind == AxisKind::linear || axis.turning != Turning::unwind || !std::isfinite(value))
        return value;
    return value - kTurn_deg * whole_turns(value);
}

}  // namespace gsim::machine
