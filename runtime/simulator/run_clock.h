#pragma once

#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"

namespace gsim::simulation {

/// Clock of a run: times of the moves so far, and the waits of the program for them.
class RunClock {
  public:
    /// Sets the motion that is timed; all arguments must outlive this.
    RunClock(MachineMotion& motion, const ProgramPosition& position, const ProgramNotifier& notifier)
        : motion_(motion), position_(position), notifier_(notifier) {}

    /// Returns the clock at the end of all moves so far, in s; the query brings the machine to a standstill.
    double time_s() {
        motion_.source().plan_to_standstill(false);
        return motion_.source().time_s();
    }
    /// Returns the clock at the end of the planned motion, in s: less than time_s() if moves are pending.
    double planned_s() const { return motion_.source().time_s(); }
    /// Lets the controller wait until all moves have been made, before it reads on.
    void wait() {
        notifier_.notify([&](ProgramObserver& observer) { observer.standstill(position_.axes()); });
        motion_.source().plan_to_standstill(true);
    }

  private:
    MachineMotion& motion_;
    const ProgramPosition& position_;
    const ProgramNotifier& notifier_;
};

}  // namespace gsim::simulation
