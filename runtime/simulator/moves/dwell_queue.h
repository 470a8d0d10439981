#pragma once

#include <string>

#include "machine/model/machine.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/moves/move_acceptance.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/run_clock.h"

namespace gsim::simulation {

/// Dwells between the moves of a program.
class DwellQueue {
  public:
    /// All arguments must outlive this.
    DwellQueue(const machine::Machine& machine, MachineMotion& motion, RunClock& clock,
               const ProgramPosition& position, ProgramState& program, MoveAcceptance& acceptance,
               const ProgramNotifier& notifier)
        : machine_(machine),
          motion_(motion),
          clock_(clock),
          position_(position),
          program_(program),
          acceptance_(acceptance),
          notifier_(notifier) {}

    /// Enqueues a dwell of the program. Returns false if the run has ended.
    bool enqueue(double seconds, const SourceLocation& location);
    /// Enqueues a dwell for an action that a word of the program has started ([times] of the machine file).
    /// It is part of the program's time but not a programmed dwell, so the observer is not notified. `key`:
    /// of the table. Returns false if the run has ended.
    bool enqueue_for_word(double seconds, std::string key, const SourceLocation& location);
    /// Returns the sum of the dwells for words, in s.
    double words_s() const { return words_s_; }

  private:
    motion::EnqueueResult enqueue(const DwellRequest& request);

    const machine::Machine& machine_;
    MachineMotion& motion_;
    RunClock& clock_;
    const ProgramPosition& position_;
    ProgramState& program_;
    MoveAcceptance& acceptance_;
    const ProgramNotifier& notifier_;
    double words_s_ = 0;
};

}  // namespace gsim::simulation
