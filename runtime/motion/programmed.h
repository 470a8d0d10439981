#pragma once

#include <optional>

#include "runtime/motion/move_rules.h"
#include "runtime/motion/planner_setup.h"
#include "runtime/motion/ramps.h"
#include "runtime/motion/s_curve.h"
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
    rrs::JointPos joint_jerks;          ///< mm/s3 or rad/s3
    ProgrammedRamps ramps;
    double speed_override = 1;     ///< Of the services; the operator's counts beside it.
    ObeyedOverrides obeyed;        ///< Of the operator's.
    bool follows_spindle = false;  ///< Speeds go by turns of the spindle.
    double acceleration_override = 1;
    double motion_time_s = 0;        ///< Of the next target alone; 0: none.
    double rest_s = 0;               ///< Behind the next target alone.
    bool settles = true;             ///< Exact stops wait
    std::optional<double> settle_s;  ///< for this long; none: for the machine's time.
    int flyby_criterion = 0;         ///< 0: the machine's own.
    double blend_tolerance_mm = 0;   ///< Of the fly-by criterion that has one.
    double interpolation_s = 0.01;

    /// The rules for a linear or circular move now.
    MoveRules rules(const PathLimits& path) const;
    /// What a joint may do in joint motion now, within the limits in force, at a share of its speed (above 1:
    /// of the programmed one).
    LawLimits joint_limits(const PlannerSetup& setup, int joint, double speed_share) const;
};

}  // namespace gsim::motion
