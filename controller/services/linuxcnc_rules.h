#pragma once

namespace gsim::rrs {

/// LinuxCNC release of the planner PlannerKind::linuxcnc.
enum class LinuxcncRelease {
    v2_9,
    v2_10,  ///< With straight ramps, or S-curves if the jerk is limited.
};

/// Rules of PlannerKind::linuxcnc alone.
struct LinuxcncRules {
    LinuxcncRelease release = LinuxcncRelease::v2_9;

    bool operator==(const LinuxcncRules&) const = default;
};

}  // namespace gsim::rrs
