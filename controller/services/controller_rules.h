#pragma once

#include <string>

#include "controller/services/block_rules.h"
#include "controller/services/coordination_rules.h"
#include "controller/services/corner_override_rules.h"
#include "controller/services/corner_rules.h"
#include "controller/services/curve_rules.h"
#include "controller/services/drilling_rules.h"
#include "controller/services/klipper_rules.h"
#include "controller/services/linuxcnc_rules.h"
#include "controller/services/override_rules.h"
#include "controller/services/planner_capabilities.h"
#include "controller/services/planner_kind.h"
#include "controller/services/position_loop_rules.h"
#include "controller/services/ramp_rules.h"
#include "controller/services/retraction_rules.h"
#include "controller/services/standstill_rules.h"

namespace gsim::rrs {

/// The rules by which a controller turns moves into motion: those built in by its maker, which an operator
/// cannot change. Read from a controller file; a machine file may change each key; see docs/machine-file.md.
struct ControllerRules {
    std::string model = "exact-stop";
    PlannerKind planner = PlannerKind::rest_to_rest;
    LinuxcncRules linuxcnc = {};
    KlipperRules klipper = {};
    BlockRules blocks = {};
    CornerRules corners = {};
    RampRules ramps = {};
    CurveRules curves = {};
    CoordinationRules coordination = {};
    PositionLoopRules position_loop = {};
    StandstillRules standstill = {};
    OverrideRules overrides = {};
    CornerOverrideRules corner_override = {};
    DrillingRules drilling = {};
    RetractionRules retraction = {};

    /// Returns what the planner can do.
    constexpr const PlannerCapabilities& capabilities() const { return capabilities_of(planner); }

    /// True if the planner supports OrientationRule::great_circle; one that knows only lines in joint space
    /// does not.
    bool has_great_circles() const {
        return capabilities().plans_great_circles && curves.arc_chord_tolerance_mm <= 0;
    }

    /// True if the planner limits the jerk if RampRules::limit_jerk is set.
    bool has_s_curves() const {
        const SCurves s_curves = capabilities().s_curves;
        return s_curves == SCurves::all ||
               (s_curves == SCurves::release_2_10 && linuxcnc.release == LinuxcncRelease::v2_10);
    }

    bool operator==(const ControllerRules&) const = default;
};

}  // namespace gsim::rrs
