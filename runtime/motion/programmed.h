#pragma once

#include "runtime/motion/move_rules.h"
#include "runtime/motion/planner_setup.h"
#include "runtime/rrs/types.h"

namespace gsim::motion {

/// What a client has selected and programmed: the modal state of a planner, with the defaults of the
/// services.
struct Programmed {
    explicit Programmed(int joint_count);

    rrs::TargetType target_type = rrs::TargetType::joint;
    rrs::MotionType motion_type = rrs::MotionType::joint;
    rrs::Dominance dominance = rrs::Dominance::automatic;
    bool rapid = false;
    rrs::PathMode path_mode = rrs::PathMode::exact_stop;
    double tolerance_mm = 0;  ///< In continuous mode; 0: as the controller does.
    double merge_tolerance_mm = 0;
    double position_speed_mm_s = 0;  ///< 0: none was programmed.
    double orientation_speed_rad_s = kUnlimited;
    double position_acceleration_mm_s2 = kUnlimited;
    double orientation_acceleration_rad_s2 = kUnlimited;
    rrs::JointPos joint_speeds;         ///< mm/s or rad/s
    rrs::JointPos joint_accelerations;  ///< mm/s2 or rad/s2
    double speed_override = 1;
    double acceleration_override = 1;
    double motion_time_s = 0;  ///< Of the next target alone; 0: none.
    double rest_s = 0;         ///< Behind the next target alone.
    double interpolation_s = 0.01;

    /// The rules for a linear or circular move now.
    MoveRules rules(const PathLimits& path) const;
    /// The speed of a joint in joint motion now, within its own limit.
    double joint_speed(const JointSetup& limits, int joint) const;
    double joint_acceleration(const JointSetup& limits, int joint) const;
};

}  // namespace gsim::motion
