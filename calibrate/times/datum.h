#pragma once

#include <optional>
#include <span>
#include <vector>

#include "calibrate/times/passages.h"
#include "calibrate/times/recorded_run.h"
#include "machine/model/machine.h"
#include "runtime/motion_sources/motion_log.h"
#include "runtime/motion_sources/motion_replay.h"

namespace gsim::calibrate {

/// A time that was recorded: from the end of one move of a run to the end of another one. The first one of a
/// run counts from where it begins to move or dwell, the last one to its end.
struct Datum {
    static constexpr std::size_t kOutside = static_cast<std::size_t>(-1);

    std::size_t run = 0;          ///< Place of its run among several.
    std::size_t from = kOutside;  ///< Place of the move in the log.
    std::size_t to = kOutside;
    double time_s = 0;
    double clock_s = 0;  ///< What the recording's clock may be off by.
};

/// What a run tells: where it has positions over time the times between ends of moves that it passes, some
/// samples apart; else its whole time. `log`: what it asks for on `machine`.
std::vector<Datum> data_of(const RecordedRun& run, const simulation::MotionLog& log,
                           const machine::Machine& machine);

/// When a run that was replayed begins to move or dwell, and when it ends: what words take before and behind
/// does not count. Nothing where nothing moves.
std::optional<Span> span_of(std::span<const simulation::ReplayedMove> moves);

/// The same time of a run that was replayed, s; 0 where it has no such moves.
double time_of(const Datum& datum, const simulation::MotionLog& log,
               std::span<const simulation::ReplayedMove> moves);

}  // namespace gsim::calibrate
