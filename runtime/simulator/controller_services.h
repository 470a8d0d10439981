#pragma once

#include <Eigen/Core>
#include <functional>

#include "controller/services/shell.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/run_clock.h"
#include "runtime/simulator/run_outcome.h"

namespace gsim::simulation {

/// Services of the controller for clients that call them by themselves, between the moves of the program.
/// Selections of these clients are for their own targets. Moves of the program inherit those that no word of
/// a program sets: accelerations, the overrides of the services, rules for corners, exact stops and
/// orientation.
class ControllerServices {
  public:
    /// Sets the controller and the run that its services change; all arguments must outlive this.
    ControllerServices(MachineMotion& motion, RunClock& clock, ProgramPosition& position,
                       ProgramState& program, RunOutcome& outcome, const ProgramNotifier& notifier)
        : motion_(motion),
          clock_(clock),
          position_(position),
          program_(program),
          outcome_(outcome),
          notifier_(notifier) {}

    /// Returns all services; those that change the position of the program have functions here.
    rrs::Shell& shell() { return motion_.source().shell(); }
    /// Sets the position at time 0 by a service; rejected later, because the machine cannot jump.
    rrs::Status set_start(const std::function<rrs::Status()>& set);
    /// Enqueues a target: `queue` receives its id and calls the service.
    rrs::Status queue_target(MoveKind kind, const SourceLocation& location,
                             const std::function<rrs::Status(rrs::TargetId)>& queue);
    /// Calls CancelMotion for a client that steps by itself: the program continues from its present position.
    rrs::Status cancel_motion();

    /// Calls SelectTracking for a client that defines its conveyors itself: targets of the program are in the
    /// frame of the conveyor, or no longer.
    rrs::Status select_tracking(int conveyor, bool on);
    /// Sets the targets that follow to be in the frame of a conveyor, until untrack(). `direction` is in the
    /// machine's world; the machine's frame and the conveyor's coincide if its travel is 0. Returns false on
    /// an alarm.
    bool track(const Eigen::Vector3d& direction, double position_mm, double speed_mm_s,
               const SourceLocation& location);
    /// Ends track(). Returns false on an alarm.
    bool untrack(const SourceLocation& location);

  private:
    MachineMotion& motion_;
    RunClock& clock_;
    ProgramPosition& position_;
    ProgramState& program_;
    RunOutcome& outcome_;
    const ProgramNotifier& notifier_;
};

}  // namespace gsim::simulation
