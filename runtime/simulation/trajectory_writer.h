#pragma once

#include <cstdint>

#include "runtime/machine/machine.h"
#include "runtime/simulation/run_output.h"
#include "runtime/simulation/text_stream.h"

namespace gsim::simulation {

/// Writes samples of the trajectory as CSV (docs/report.md): one line for each multiple of the step, computed
/// as k step so that no error adds up, and one for the last instant.
class TrajectoryWriter : public RunOutput {
  public:
    /// `step_s` must be at least kMinStep_s; throws std::invalid_argument otherwise. Past `max_time_s`, where
    /// a run ends, there is the last instant alone: a single move may take years. `out` and `machine` must
    /// outlive this. Behind `most_samples` it writes none.
    TrajectoryWriter(TextStream& out, const machine::Machine& machine, double step_s, double max_time_s,
                     std::uint64_t most_samples = kMostSamples);

    static constexpr double kMinStep_s = 1e-6;
    static constexpr std::uint64_t kMostSamples = 100'000'000;  ///< Some 5 GB.

    /// Whether samples are missing, as there would be too many.
    bool cut_short() const { return cut_short_; }

    using RunOutput::take;
    void begin(const rrs::JointPos& start) override;
    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

  private:
    bool due(double before_s);
    double next_s() const { return static_cast<double>(next_) * step_s_; }
    void write_header();
    void write_sample(double t_s, const rrs::JointPos& joints, double speed_mm_s);

    TextStream& out_;
    const machine::Machine& machine_;
    double step_s_;
    double max_time_s_;
    std::uint64_t most_samples_;
    bool cut_short_ = false;
    std::uint64_t next_ = 0;  // number of the next sample
    rrs::JointPos position_;  // at the end of the last segment
    std::uint32_t line_ = 0;
};

}  // namespace gsim::simulation
