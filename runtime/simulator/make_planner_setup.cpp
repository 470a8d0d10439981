#include "runtime/simulator/make_planner_setup.h"

#include "base/units.h"

namespace gsim::simulation {

namespace {

/// The language limits the difference of an arc's radii (lua_lib/common/arcs.lua). The planner accepts what a
/// language permits as a spiral.
constexpr double kArcTolerance_mm = 10;

}  // namespace

motion::PlannerSetup make_planner_setup(const machine::Machine& machine) {
    motion::PlannerSetup setup;
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        const bool rotary = axis.kind == machine::AxisKind::rotary;
        const double unit = rotary ? kRadPerDeg : 1.0;
        motion::JointSetup joint;
        joint.kind = rotary ? rrs::JointKind::revolute : rrs::JointKind::prismatic;
        joint.min = (axis.min - axis.zero) * unit;
        joint.max = (axis.max - axis.zero) * unit;
        joint.max_speed = axis.max_speed * unit;
        joint.max_acceleration = axis.max_acceleration * unit;
        if (axis.max_deceleration) joint.max_deceleration = *axis.max_deceleration * unit;
        joint.max_jerk = axis.max_jerk * unit;
        joint.max_speed_step = axis.max_speed_step * unit;
        joint.step = axis.step * unit;
        setup.joints.push_back(joint);
        if (!rotary && axis.letter >= 'X' && axis.letter <= 'Z') {
            setup.position_joints[static_cast<std::size_t>(axis.letter - 'X')] = static_cast<int>(i);
        }
    }
    setup.path.max_feed_mm_s = machine.path.max_feed_mm_s;
    setup.path.max_rapid_mm_s = machine.path.max_rapid_mm_s;
    setup.path.max_acceleration_mm_s2 = machine.path.max_acceleration_mm_s2;
    setup.path.max_rapid_acceleration_mm_s2 = machine.path.max_rapid_acceleration_mm_s2;
    setup.path.max_jerk_mm_s3 = machine.path.max_jerk_mm_s3;
    setup.controller = machine.controller;
    setup.arc_tolerance_mm = kArcTolerance_mm;
    setup.kinematics = machine::make_kinematics(machine);
    setup.overtravel_log = std::make_shared<motion::OvertravelLog>();
    return setup;
}

}  // namespace gsim::simulation
