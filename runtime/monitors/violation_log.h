#pragma once

#include <deque>
#include <vector>

#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"
#include "runtime/simulator/required_offset_shifts.h"

namespace gsim::simulation {

/// Violations of a run. A move past the ranges of axes is known before it is made, and so before its time is.
class ViolationLog final : public RunOutput {
  public:
    /// Adds a violation of the move with this target id, yet to be made, which takes an axis past its range.
    void add_before(rrs::TargetId id, Violation violation);
    /// Adds a violation at a known time; at most kMaxViolations of these.
    void add(Violation violation);

    void on_move(const RecordedMove& move) override;
    void end(double end_s) override;

    /// Returns all of them by time; those that are not listed are counted. `further`: number of others that
    /// were not added. Call it once, after the end of the run.
    Violations release(std::uint64_t further);

  private:
    struct PendingViolation {
        rrs::TargetId id;
        Violation violation;
    };

    void count(const Violation& violation);
    void insert(Violation violation, double t_s);

    std::deque<PendingViolation>
        pending_violations_;  ///< By id; at most kMaxViolations, together with moves_.
    std::vector<Violation> list_;
    std::uint64_t count_ = 0;
    std::uint64_t moves_ = 0;  ///< Number of moves in list_.
    RequiredOffsetShifts required_shifts_;
};

}  // namespace gsim::simulation
