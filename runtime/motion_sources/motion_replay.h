#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "machine/model/machine.h"
#include "motion/planner/planner.h"
#include "runtime/motion_sources/motion_log.h"

namespace gsim::simulation {

/// Repeats a run's request to its controller with a planner, on a machine with these times of words. A word
/// without a time gets no dwell. The keys of dwells are those of the machine of the run: this one names the
/// same codes in [times].
motion::PlanResult replay_request(const MotionRequest& request, const machine::WordTimes& times,
                                  motion::Planner& planner);

/// Time of a move or a dwell of a log, s.
struct ReplayedMove {
    rrs::TargetId target_id = 0;
    double start_s = 0;
    double end_s = 0;
    bool is_standstill = false;  ///< Standstill, no programmed dwell: for a word, or the controller itself.
    bool is_for_word = false;    ///< Then: for a word.
};

/// Replays a log without a gap, on a machine that differs from its own in parameters only, with our planner.
/// Returns the moves that take time, in order. Zones, cells and tables of the machine are not checked. The
/// error names the entry that cannot be planned, and the reason.
Result<std::vector<ReplayedMove>> replay(const MotionLog& log, const motion::PlannerSetup& machine,
                                         const machine::WordTimes& times);

}  // namespace gsim::simulation
