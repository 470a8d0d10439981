#pragma once

#include <memory>
#include <string_view>

#include "controller/services/types.h"
#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/profile/ramps.h"
#include "motion/profile/s_curve.h"

namespace gsim::motion {

/// Programmed values of single joints, only for joint motion.
struct JointParameters {
    explicit JointParameters(int joint_count);

    rrs::JointPos speeds;         ///< mm/s or rad/s
    rrs::JointPos accelerations;  ///< mm/s2 or rad/s2
    rrs::JointPos jerks;          ///< mm/s3 or rad/s3
};

/// Parameters of a move that a program requests, except the path. The defaults are those of the services.
struct MoveParameters {
    rrs::Dominance dominance = rrs::Dominance::automatic;
    bool rapid = false;
    rrs::PathMode path_mode = rrs::PathMode::exact_stop;
    double tolerance_mm = 0;  ///< In continuous mode; 0: as the controller does.
    double merge_tolerance_mm = 0;
    double position_speed_mm_s = 0;  ///< 0: none was programmed.
    double orientation_speed_rad_s = kUnlimited;
    double position_acceleration_mm_s2 = kUnlimited;
    double orientation_acceleration_rad_s2 = kUnlimited;
    double motion_time_s = 0;   ///< Instead of a time from programmed speeds; 0: none.
    double speed_override = 1;  ///< Override of the services; the operator's counts as well.
    double acceleration_override = 1;
    EnabledOverrides enabled_overrides;             ///< Operator overrides.
    bool follows_spindle = false;                   ///< Speeds go by turns of the spindle.
    std::shared_ptr<const JointParameters> joints;  ///< Null: the joints' own limits.
    std::shared_ptr<const ProgrammedRamps> ramps;   ///< Null: the machine's own.
    /// The machine with other rules for corners, exact stops and orientation; null: as it is.
    std::shared_ptr<const PlannerSetup> machine;

    rrs::RampMode ramp_mode() const { return ramps ? ramps->mode : rrs::RampMode::machine; }
    /// Returns the rules for a linear or circular move.
    MoveRules rules(const PathLimits& path) const;
    /// Returns what a joint may do in joint motion, within the active limits, at a share of its speed (above
    /// 1: of the programmed one).
    LawLimits joint_limits(const PlannerSetup& setup, int joint, double speed_share) const;
};

/// Checks that a programmed value is above 0; `what` is its name. Error: RRS_INVALID_PARAMETER.
PlanResult check_positive(double value, std::string_view what);
/// Checks that a move may be requested to take a time. Error: RRS_INVALID_PARAMETER.
PlanResult check_motion_time(double motion_s);

}  // namespace gsim::motion
