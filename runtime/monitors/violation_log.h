#pragma once

#include <deque>
#include <vector>

#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"
#include "runtime/simulator/offset_needs.h"

namespace gsim::simulation {

/// Violations of a run. A move past the ranges of axes is known before it is made, and so before its time is.
class ViolationLog final : public RunOutput {
  public:
    /// Adds a violation of the move with this target id, yet to be made, which takes an axis past its range.
    void add_before(rrs::TargetId id, Violation violation);
    /// Adds a violation at a known time; at most kMostViolations of these.
    void add(Violation violation);

    void take(const RecordedMove& move) override;
    void end(double end_s) override;

    /// Returns all of them by time; those that are not listed are counted. `further`: number of others that
    /// were not added. Call it once, after the end of the run.
    Violations release(std::uint64_t further);

  private:
    struct Waiting {
        rrs::TargetId id;
        Violation violation;
    };

    void count(const Violation& violation);
    void put(Violation violation, double t_s);

    std::deque<Waiting> waiting_;  ///< By id; at most kMostViolations, together with moves_.
    std::vector<Violation> list_;
    std::uint64_t count_ = 0;
    std::uint64_t moves_ = 0;  ///< Number of moves in list_.
    OffsetNeeds needs_;
};

}  // namespace gsim::simulation
