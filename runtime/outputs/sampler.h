#pragma once

#include <cstdint>

#include "runtime/outputs/run_output.h"

namespace gsim::simulation {

/// Sampling of a run at each multiple of a step, computed as k step so that no error adds up, and at its last
/// instant.
class Sampler : public RunOutput {
  public:
    static constexpr double kMinStep_s = 1e-6;

    /// `step_s` must be at least kMinStep_s; throws std::invalid_argument otherwise. Past `max_time_s`, at
    /// which a run ends, only the last instant follows: a single move may take years.
    Sampler(double step_s, double max_time_s);

    void begin(const rrs::JointPos& start) override { position_ = start; }
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

  protected:
    /// Returns the segment of the current instant; time_in_segment_s() returns the time since its start. Null
    /// between segments and at the end, when the machine is at standstill.
    const motion::Segment* segment() const { return segment_; }
    double time_in_segment_s() const { return time_in_segment_s_; }

  private:
    /// Processes an instant; returns false if no more are wanted.
    virtual bool sample(double t_s, const rrs::JointPos& joints, double speed_mm_s, std::uint32_t line) = 0;
    bool is_due(double before_s) const;
    double next_s() const { return static_cast<double>(next_) * step_s_; }

    double step_s_;
    double max_time_s_;
    bool accepts_samples_ = true;
    std::uint64_t next_ = 0;  // number of the next sample
    rrs::JointPos position_;  // at the end of the last segment
    std::uint32_t line_ = 0;
    const motion::Segment* segment_ = nullptr;
    double time_in_segment_s_ = 0;
};

}  // namespace gsim::simulation
