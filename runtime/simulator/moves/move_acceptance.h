#pragma once

#include "motion/planner/plan_error.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/move_settings.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/run_outcome.h"
#include "runtime/simulator/run_violations.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Acceptance of moves by the controller: what it rejects or changes becomes alarms, violations and warnings.
class MoveAcceptance {
  public:
    /// All arguments must outlive this.
    MoveAcceptance(MachineMotion& motion, ProgramPosition& position, MoveSettings& settings,
                   RunOutcome& outcome, RunViolations& violations, Warnings& warnings,
                   const ProgramNotifier& notifier)
        : motion_(motion),
          position_(position),
          settings_(settings),
          outcome_(outcome),
          violations_(violations),
          warnings_(warnings),
          notifier_(notifier) {}

    /// Ends the enqueueing of a move with its result. Returns false if the run has ended.
    bool finish(const motion::EnqueueResult& enqueue, const SourceLocation& location);
    /// Does the same for a move to a target, at which the program is as soon as the controller has accepted
    /// it. `notification` gets the observer and the position before.
    template <typename Notification>
    bool finish(const motion::EnqueueResult& enqueue, const AxisVector& target,
                const SourceLocation& location, const Notification& notification) {
        if (enqueue) {
            notifier_.notify([&](ProgramObserver& observer) { notification(observer, position_.axes()); });
            position_.set(target);
        }
        return finish(enqueue, location);
    }

  private:
    MachineMotion& motion_;
    ProgramPosition& position_;
    MoveSettings& settings_;
    RunOutcome& outcome_;
    RunViolations& violations_;
    Warnings& warnings_;
    const ProgramNotifier& notifier_;
};

}  // namespace gsim::simulation
