#pragma once

#include <cstdint>
#include <string>

#include "runtime/simulator/event_log.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/target_ids.h"

namespace gsim::simulation {

/// Time of an event between moves.
enum class EventTiming : std::uint8_t {
    at_standstill,  ///< The machine stops for it.
    in_passing,     ///< As the next move or dwell begins, else at the end.
    with_motion,    ///< As the next move begins that is no dwell, else never.
};

/// Events between the moves of a program.
class ProgramEvents {
  public:
    /// Begins without events. All arguments must outlive this.
    ProgramEvents(MachineMotion& motion, const ProgramPosition& position, const TargetIds& ids,
                  const ProgramNotifier& notifier);
    ProgramEvents(const ProgramEvents&) = delete;
    ProgramEvents& operator=(const ProgramEvents&) = delete;

    /// Adds an event that happens once everything before it is done.
    void add(std::string kind, std::string detail, const SourceLocation& location,
             EventTiming timing = EventTiming::at_standstill);
    /// Returns the events with their times.
    EventLog& log() { return log_; }

  private:
    MachineMotion& motion_;
    const ProgramPosition& position_;
    const TargetIds& ids_;
    const ProgramNotifier& notifier_;
    EventLog log_;
};

}  // namespace gsim::simulation
