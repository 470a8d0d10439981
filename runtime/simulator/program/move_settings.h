#pragma once

#include <memory>
#include <optional>

#include "machine/model/machine.h"
#include "motion/planner/move.h"
#include "motion/planner/planner_setup.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"

namespace gsim::simulation {

/// Overrides of the operator that the program locks: the moves that follow run as if those were at 100 %.
struct OverrideLocks {
    bool feed = false;
    bool rapid = false;
    bool spindle = false;
};

/// Limits that a program sets for its path; those that are left out stay as they are.
struct ProgrammedPathLimits {
    std::optional<double> speed_mm_s;
    std::optional<double> acceleration_mm_s2;
    std::optional<double> square_corner_velocity_mm_s;  ///< For the planner `klipper`, as the next one.
    std::optional<double> minimum_cruise_ratio;
};

/// Modal settings of the program for the path of its moves, their speed and the overrides that they obey.
class MoveSettings {
  public:
    /// Begins with exact stops, the limits of `setup` and all overrides. All arguments must outlive this.
    MoveSettings(const machine::Machine& machine, const motion::PlannerSetup& setup,
                 const ProgramPosition& position, const ProgramNotifier& notifier)
        : machine_(machine), setup_(setup), position_(position), notifier_(notifier) {}

    /// Sets how the moves that follow pass their ends, and the tolerances (mm; 0: controller's default).
    void set_path_mode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm);
    /// Ends the next move in an exact stop, in any mode.
    void exact_stop_once();
    /// Records that this move has been enqueued.
    void end_exact_stop() { exact_stop_once_ = false; }
    /// Sets limits for the moves that follow; they replace the machine's.
    void set_path_limits(const ProgrammedPathLimits& limits);
    void lock_overrides(const OverrideLocks& locks) { locks_ = locks; }
    /// Sets the speed of the spindle, rev/min, for the moves that follow. Only the observer is notified,
    /// because moves already have their feeds.
    void set_spindle_speed(double rev_min);

    /// Writes the overrides that a move of this feed obeys.
    void apply_override_rules(const Feed& feed, MoveInfo& info) const;
    /// Writes the path mode and the limits of the path.
    void apply(motion::MoveParameters& parameters) const;

  private:
    const machine::Machine& machine_;
    const motion::PlannerSetup& setup_;
    const ProgramPosition& position_;
    const ProgramNotifier& notifier_;
    PathModeSettings path_mode_;
    bool exact_stop_once_ = false;
    OverrideLocks locks_;
    std::shared_ptr<const motion::PlannerSetup> path_limits_;  ///< Null: the machine's.
};

}  // namespace gsim::simulation
