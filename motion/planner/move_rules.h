#pragma once

#include "controller/services/types.h"
#include "motion/planner/override_schedule.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Rules for the time of one linear or circular move, in addition to the limits of its joints.
struct MoveRules {
    double programmed_speed_mm_s = kUnlimited;  ///< Speed of the tool along its path; 0: none was programmed.
    double max_path_speed_mm_s = kUnlimited;
    double path_acceleration_mm_s2 = kUnlimited;
    double orientation_speed_rad_s = kUnlimited;
    double orientation_acceleration_rad_s2 = kUnlimited;
    rrs::Dominance dominance = rrs::Dominance::automatic;
    double min_duration_s = 0;     ///< Minimum duration of the move.
    bool follows_spindle = false;  ///< True if the programmed speed is per spindle turn.
    double rapid_share = 1;        ///< Share of the speed that the limits leave a rapid move.

    /// Returns the rules with the operator's overrides that a move obeys. A hold (0) changes none of them.
    MoveRules with_overrides(const Overrides& overrides, const EnabledOverrides& enabled_overrides,
                             bool rapid) const {
        MoveRules rules = *this;
        const double share = enabled_overrides.share(overrides, rapid);
        if (share <= 0) return rules;
        if (rapid) {
            rules.rapid_share = share;
        } else {
            rules.programmed_speed_mm_s *= share;
            rules.orientation_speed_rad_s *= share;
            rules.min_duration_s /= share;
        }
        return rules;
    }

    /// Returns the rules for a move that changes position and orientation (mixed) or only one of them:
    /// dominance deactivates the programmed speed of the other.
    MoveRules with_dominance(bool changes_both) const {
        MoveRules rules = *this;
        if (changes_both && dominance == rrs::Dominance::orientation)
            rules.programmed_speed_mm_s = kUnlimited;
        if (changes_both && dominance == rrs::Dominance::position) rules.orientation_speed_rad_s = kUnlimited;
        return rules;
    }
};

}  // namespace gsim::motion
