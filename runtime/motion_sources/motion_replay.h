#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "machine/model/machine.h"
#include "motion/planner/planner.h"
#include "runtime/motion_sources/motion_log.h"

namespace gsim::simulation {

/// Asks a planner for what a run has asked its controller for, on a machine whose words take these times. A
/// word that takes none there is no rest. The keys of rests are those of the machine that the run was made
/// on: it names the same codes in [times].
motion::Planned ask_again(const MotionAsk& ask, const machine::WordTimes& times, motion::Planner& planner);

/// When a move or a rest of a log was made, s.
struct ReplayedMove {
    rrs::TargetId target_id = 0;
    double start_s = 0;
    double end_s = 0;
    bool rests = false;    ///< And the program asks for no dwell: for a word, or the control itself.
    bool of_word = false;  ///< Then: for a word.
};

/// What becomes of a log that has no gap on a machine that is another than its own in figures alone, with our
/// planner: the moves that take time, in order. Zones, cells and tables of the machine are not looked at. The
/// error says which entry cannot be planned, and why.
tl::expected<std::vector<ReplayedMove>, std::string> replay(const MotionLog& log,
                                                            const motion::PlannerSetup& machine,
                                                            const machine::WordTimes& times);

}  // namespace gsim::simulation
