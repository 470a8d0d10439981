#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "machine/model/machine.h"
#include "motion/segment/segment.h"
#include "runtime/monitors/compensated_sum.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Combination of the client's data on moves and the segments that the planner makes of them: sums up the
/// report and feeds the outputs. Memory is bounded by the moves that wait for their segments.
///
/// A move consists of all segments with its target id; they come in a row, in the order of expect(). It
/// counts, and is passed to the outputs, if it takes time or is a dwell; a move to the current position does
/// neither. Standstills count as dwell whatever the move is. An unexpected segment counts in time and length,
/// but makes no move.
class Recorder : public motion::SegmentSink {
  public:
    /// Sets `machine` and `start` (joint values, mm or rad), which hold from time 0 on; `machine` must
    /// outlive this.
    Recorder(const machine::Machine& machine, const rrs::JointPos& start);

    /// Adds an output, before the first segment. `output` must outlive this.
    void add_output(RunOutput& output);

    /// Announces a move, before its first segment.
    void expect(const MoveInfo& info) { pending_moves_.push_back(info); }
    void on_segment(const motion::Segment& segment) override;
    /// Marks that the move announced last exceeds the ranges of these joints (MoveInfo::out_of_range).
    void mark_last_out_of_range(std::uint16_t out_of_range);

    /// Returns the move with the arriving segments; an unexpected one has only an id.
    const MoveInfo& move() const { return move_.info; }
    /// Returns the end of the segments so far.
    double time_s() const { return end_s_; }

    /// Ends the outputs and fills in the recorder's part of a report: times, lengths, moves, bounds, slowest
    /// and the name of the machine. Call it once, after the last segment.
    void finish(Report& report);

  private:
    // List with the highest first; of equals the earlier one first.
    class SlowestMoves {
      public:
        void add(const RecordedMove& move);
        std::vector<SlowBlock> list(const machine::Machine& machine) const;

      private:
        std::array<RecordedMove, 10> moves_;
        std::ptrdiff_t count_ = 0;
    };

    bool is_between_moves(const motion::Segment& segment) const;
    void add_between_moves(const motion::Segment& standstill);
    void advance_to_move(rrs::TargetId id);
    void begin_move(const MoveInfo& info);
    void end_move();
    void add_limit(const motion::Segment& segment);
    void add_to_sums(const motion::Segment& segment);
    void add_to_bounds(const motion::Segment& segment);
    std::vector<AxisBounds> bounds() const;

    const machine::Machine& machine_;
    std::vector<RunOutput*> outputs_;
    rrs::JointPos start_;
    std::deque<MoveInfo> pending_moves_;
    RecordedMove move_;     // the one with arriving segments
    double longest_s_ = 0;  // of its segments
    bool in_move_ = false;  // move_ was expected, so that it may count
    double end_s_ = 0;
    std::uint64_t moves_ = 0;
    CompensatedSum rapid_s_, feed_s_, dwell_s_, rapid_mm_, feed_mm_, process_on_mm_;
    CompensatedSum feed_locked_s_, rapid_locked_s_, spindle_locked_s_;  // against the operator's overrides
    std::array<motion::Range, rrs::kMaxJoints> ranges_;  // of joint values; the first joint_count hold them
    SlowestMoves slowest_;
};

}  // namespace gsim::simulation
