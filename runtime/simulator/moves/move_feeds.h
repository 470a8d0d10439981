#pragma once

#include "machine/model/machine.h"
#include "motion/planner/move.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/run_outcome.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Feeds of the program's moves: their checks, and the speed or the time that a move gets from them.
class MoveFeeds {
  public:
    /// All arguments must outlive this.
    MoveFeeds(const machine::Machine& machine, const ProgramPosition& position, RunOutcome& outcome,
              Warnings& warnings)
        : machine_(machine), position_(position), outcome_(outcome), warnings_(warnings) {}

    /// Returns false, with an alarm, if the feed is not positive; `rotary`: only rotary axes move.
    bool check(const Feed& feed, bool rotary, const SourceLocation& location);
    /// Writes the speed or the time of a move. Warns if the speed is above the machine's.
    void apply(const Feed& feed, bool rotary, motion::Move& move);
    /// Returns the feed for reports, in mm/min or deg/min; for a move with a time of its own (inverse time
    /// feed) its mean.
    double per_min(const LineMove& move, bool rotary) const;
    double per_min(const ArcMove& move) const;

  private:
    const machine::Machine& machine_;
    const ProgramPosition& position_;
    RunOutcome& outcome_;
    Warnings& warnings_;
    double warned_feed_mm_s_ = 0;  ///< Above the machine's.
};

}  // namespace gsim::simulation
