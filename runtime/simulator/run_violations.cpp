#include "runtime/simulator/run_violations.h"

namespace gsim::simulation {

RunViolations::RunViolations(const machine::Machine& machine, MachineMotion& motion,
                             const ProgramState& program, RunOutcome& outcome, EventLog& events)
    : zone_monitor_(motion.zones()),
      ranges_(machine, motion, program, outcome, log_),
      zones_(motion, program, outcome, events) {
    motion.recorder().add_output(log_);
}

void RunViolations::end_run() {
    zones_.check();
    ranges_.add_steps();
}

Violations RunViolations::release() {
    zones_.release(log_);
    return log_.release(zone_monitor_.further_hits());
}

}  // namespace gsim::simulation
