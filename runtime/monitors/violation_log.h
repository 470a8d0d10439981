#pragma once

#include <deque>
#include <vector>

#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"
#include "runtime/simulator/offset_needs.h"

namespace gsim::simulation {

/// The violations of a run. That a move takes axes past their ranges is known before it is made, and so
/// before its time is.
class ViolationLog final : public RunOutput {
  public:
    /// The move with this target id, yet to be made, takes an axis past its range.
    void add_before(rrs::TargetId id, Violation violation);
    /// Something at a known time; kMostViolations of these at most.
    void add(Violation violation);

    void take(const RecordedMove& move) override;
    void end(double end_s) override;

    /// All of them by time; what is not listed is counted. `further`: how many more there were that were not
    /// added. Call it once, behind the end of the run.
    Violations release(std::uint64_t further);

  private:
    struct Waiting {
        rrs::TargetId id;
        Violation violation;
    };

    void count(const Violation& violation);
    void put(Violation violation, double t_s);

    std::deque<Waiting> waiting_;  ///< In the order of their ids; with moves_ kMostViolations at most.
    std::vector<Violation> list_;
    std::uint64_t count_ = 0;
    std::uint64_t moves_ = 0;  ///< Of list_, those of moves.
    OffsetNeeds needs_;
};

}  // namespace gsim::simulation
