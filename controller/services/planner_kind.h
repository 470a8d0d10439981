#pragma once

namespace gsim::rrs {

/// Planner of a controller. A new one needs a row in kPlannerCapabilities and an implementation of
/// motion::MotionModel.
enum class PlannerKind {
    rest_to_rest,  ///< Each move begins and ends at standstill.
    look_ahead,    ///< Speeds at the corners by the CornerRules, over a window of blocks.
    linuxcnc,      ///< The trajectory planner of LinuxCNC: blend arcs, parabolic blends, servo cycles.
    klipper,       ///< The look-ahead of Klipper: square corner velocity, minimum cruise ratio.
};

}  // namespace gsim::rrs
