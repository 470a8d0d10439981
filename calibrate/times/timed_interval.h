#pragma once

#include <optional>
#include <span>
#include <vector>

#include "calibrate/times/passage_times.h"
#include "calibrate/times/recorded_run.h"
#include "machine/model/machine.h"
#include "runtime/motion_sources/motion_log.h"
#include "runtime/motion_sources/motion_replay.h"

namespace gsim::calibrate {

/// Recorded time from the end of one move of a run to the end of another one. The first one of a run starts
/// with its first motion or dwell, the last one ends with the run.
struct TimedInterval {
    static constexpr std::size_t kRunBoundary = static_cast<std::size_t>(-1);

    std::size_t run = 0;              ///< Index of its run among several.
    std::size_t from = kRunBoundary;  ///< Index of the move in the log.
    std::size_t to = kRunBoundary;
    double time_s = 0;
    double clock_error_s = 0;  ///< Possible error of the recording's clock.
};

/// Returns the data of a run. If it has positions over time, these are the times between ends of moves that
/// it passes, some samples apart; else its total time. `log`: its requests on `machine`.
std::vector<TimedInterval> timed_intervals(const RecordedRun& run, const simulation::MotionLog& log,
                                           const machine::Machine& machine);

/// Returns when a replayed run begins to move or dwell, and when it ends: times of leading and trailing words
/// do not count. Empty if no axis moves.
std::optional<TimeSpan> replay_span(std::span<const simulation::ReplayedMove> moves);

/// Returns the same time for a replayed run, s; 0 if it has no such moves.
double interval_time_s(const TimedInterval& datum, const simulation::MotionLog& log,
                       std::span<const simulation::ReplayedMove> moves);

}  // namespace gsim::calibrate
