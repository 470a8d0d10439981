#pragma once

#include "machine/model/machine.h"
#include "runtime/monitors/violation_log.h"
#include "runtime/report/report.h"
#include "runtime/simulator/event_log.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/range_violations.h"
#include "runtime/simulator/run_outcome.h"
#include "runtime/simulator/zone_violations.h"

namespace gsim::simulation {

/// Violations of a run, of ranges of axes and of zones, in one list.
class RunViolations {
  public:
    /// Begins without violations. All arguments must outlive this.
    RunViolations(const machine::Machine& machine, MachineMotion& motion, const ProgramState& program,
                  RunOutcome& outcome, EventLog& events);

    RangeViolations& ranges() { return ranges_; }
    /// Returns false, with an alarm, if a violation by the motion so far has ended the run.
    bool check() { return zones_.check() && ranges_.check_steps(); }
    /// Adds the violations of the full motion, or their alarm. Call it once, after the end of the run.
    void end_run();
    /// Returns all violations by time. Call it once, after end_run().
    Violations release();

  private:
    const ZoneMonitor& zone_monitor_;
    ViolationLog log_;
    RangeViolations ranges_;
    ZoneViolations zones_;
};

}  // namespace gsim::simulation
