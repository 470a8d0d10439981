#pragma once

#include <vector>

#include "runtime/monitors/violation_log.h"
#include "runtime/simulator/event_log.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/run_outcome.h"

namespace gsim::simulation {

/// Violations of zones by the tool. A run then continues unless its limits end it.
class ZoneViolations {
  public:
    /// Begins without violations. All arguments must outlive this.
    ZoneViolations(MachineMotion& motion, const ProgramState& program, RunOutcome& outcome, EventLog& events);
    ZoneViolations(const ZoneViolations&) = delete;
    ZoneViolations& operator=(const ZoneViolations&) = delete;

    /// Returns false, with an alarm, if the tool has violated a zone and so ended the run.
    bool check();
    /// Moves the violations to a log. Call it once, after the end of the run.
    void release(ViolationLog& log);

  private:
    bool fail_in_zone(const ZoneHit& hit);
    void add(const ZoneHit& hit);

    MachineMotion& motion_;
    const ProgramState& program_;
    RunOutcome& outcome_;
    EventLog& events_;
    std::vector<Violation> violations_;  ///< For the hits of the zone monitor, in their order.
};

}  // namespace gsim::simulation
