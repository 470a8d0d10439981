#pragma once

#include "controller/services/types.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Ramps that a program has selected for speeding up and slowing down. They lower what the machine's joints
/// may do; infinite ramps deactivate them.
struct ProgrammedRamps {
    explicit ProgrammedRamps(int joint_count);

    rrs::RampMode mode = rrs::RampMode::machine;
    rrs::JointPos accelerations;  ///< mm/s2 or rad/s2; infinite: the machine's.
    rrs::JointPos decelerations;  ///< mm/s2 or rad/s2
    rrs::JointPos jerks;          ///< mm/s3 or rad/s3

    rrs::JointPos& of(rrs::RampLimit limit);
};

/// Activates ramps: sets the limits of joints and path in `setup`, and the flag for its jerk limit, to those
/// of `machine` as the ramps lower them.
void activate_ramps(const ProgrammedRamps& ramps, const PlannerSetup& machine, PlannerSetup& setup);

}  // namespace gsim::motion
