#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "machine/model/machine.h"
#include "runtime/monitors/compensated_sum.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// Sum of the times for which each kind of limit kept the machine from being faster, and of its standstill.
class TimeByLimit : public RunOutput {
  public:
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;

    /// Returns the times, the longest first; limits without time are omitted. The times add up to the cycle
    /// time.
    std::vector<LimitTime> list(const machine::Machine& machine) const;

  private:
    static constexpr std::size_t kKinds =
        static_cast<std::size_t>(motion::LimitKind::unknown) + 1;  // the last of them
    static constexpr std::size_t kJoints = rrs::kMaxJoints + 1;    // the first: no joint

    std::array<std::array<CompensatedSum, kJoints>, kKinds> limits_;
    CompensatedSum dwell_s_;
};

}  // namespace gsim::simulation
