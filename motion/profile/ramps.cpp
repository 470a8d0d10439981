#include "motion/profile/ramps.h"

#include <algorithm>

namespace gsim::motion {

using rrs::RampLimit;
using rrs::RampMode;

ProgrammedRamps::ProgrammedRamps(int joint_count)
    : accelerations(rrs::JointPos::Constant(joint_count, kUnlimited)),
      decelerations(accelerations),
      jerks(accelerations) {}

rrs::JointPos& ProgrammedRamps::of(RampLimit limit) {
    switch (limit) {
        case RampLimit::acceleration: return accelerations;
        case RampLimit::deceleration: return decelerations;
        case RampLimit::jerk: break;
    }
    return jerks;
}

void activate_ramps(const ProgrammedRamps& ramps, const PlannerSetup& machine, PlannerSetup& setup) {
    const bool infinite = ramps.mode == RampMode::infinite;
    for (int joint = 0; joint < machine.joint_count(); ++joint) {
        const JointSetup& joint_setup = machine.joints[static_cast<std::size_t>(joint)];
        JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        limits.max_acceleration =
            infinite ? kUnlimited : std::min(joint_setup.max_acceleration, ramps.accelerations[joint]);
        limits.max_deceleration =
            infinite ? kUnlimited : std::min(joint_setup.deceleration(), ramps.decelerations[joint]);
        limits.programmed_acceleration = ramps.accelerations[joint];
        limits.programmed_deceleration = ramps.decelerations[joint];
        limits.max_jerk = infinite ? kUnlimited : std::min(joint_setup.max_jerk, ramps.jerks[joint]);
    }
    if (infinite) setup.move_limits = nullptr;
    setup.path.max_rapid_acceleration_mm_s2 =
        infinite ? kUnlimited : machine.path.max_rapid_acceleration_mm_s2;
    setup.path.max_acceleration_mm_s2 = infinite ? kUnlimited : machine.path.max_acceleration_mm_s2;
    setup.controller.ramps.limit_jerk =
        ramps.mode == RampMode::s_curve ||
        (ramps.mode == RampMode::machine && machine.controller.ramps.limit_jerk);
}

}  // namespace gsim::motion
