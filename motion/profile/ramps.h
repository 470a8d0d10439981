#pragma once

#include "controller/services/types.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// What a program has selected for speeding up and slowing down; it lowers what the machine's joints may do,
/// and infinite ramps put it out of force.
struct ProgrammedRamps {
    explicit ProgrammedRamps(int joint_count);

    rrs::RampMode mode = rrs::RampMode::machine;
    rrs::JointPos accelerations;  ///< mm/s2 or rad/s2; infinite: the machine's.
    rrs::JointPos decelerations;  ///< mm/s2 or rad/s2
    rrs::JointPos jerks;          ///< mm/s3 or rad/s3

    rrs::JointPos& of(rrs::RampLimit limit);
};

/// Puts ramps in force: sets the limits of joints and path in `setup`, and whether it limits the jerk, to
/// those of `machine` as the ramps lower them.
void put_in_force(const ProgrammedRamps& ramps, const PlannerSetup& machine, PlannerSetup& setup);

}  // namespace gsim::motion
