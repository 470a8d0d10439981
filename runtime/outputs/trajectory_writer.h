#pragma once

#include <cstdint>
#include <optional>

#include "machine/model/machine.h"
#include "motion/dynamics/segment_efforts.h"
#include "runtime/monitors/following_motion.h"
#include "runtime/outputs/sampler.h"
#include "runtime/outputs/text_stream.h"

namespace gsim::simulation {

/// Writer of trajectory samples as CSV (docs/report.md), one line for each.
class TrajectoryWriter : public Sampler {
  public:
    /// Sets the step as in Sampler. `out` and `machine` must outlive this. Past `max_samples` it writes only
    /// the last instant.
    TrajectoryWriter(TextStream& out, const machine::Machine& machine, double step_s, double max_time_s,
                     std::uint64_t max_samples = kMaxSamples);

    static constexpr std::uint64_t kMaxSamples = 100'000'000;  ///< Some 5 GB.

    /// Adds, before the run, the efforts of the motors and their power to each sample. `dynamics` must
    /// outlive this.
    void add_efforts(const dynamics::Dynamics& dynamics) { efforts_.emplace(dynamics); }

    /// Adds, before the run, the deviation of axes and TCP from their set points and the real TCP to each
    /// sample.
    void add_following(const FollowingSetup& setup) { following_.emplace(setup); }

    /// Returns true if samples are missing, because they would be too many.
    bool is_truncated() const { return is_truncated_; }

    void begin(const rrs::JointPos& start) override;
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

  private:
    void write_header();
    void write_efforts(const rrs::JointPos& joints);
    void write_following(double t_s);
    void enter_segment(const motion::Segment& segment);
    bool sample(double t_s, const rrs::JointPos& joints, double speed_mm_s, std::uint32_t line) override;

    TextStream& out_;
    const machine::Machine& machine_;
    std::optional<dynamics::SegmentEfforts> efforts_;
    std::optional<FollowingMotion> following_;
    MoveInfo info_;                     // of the segment that is sampled,
    bool has_entered_segment_ = false;  // which following_ knows
    std::uint64_t max_samples_;
    std::uint64_t samples_ = 0;
    bool is_truncated_ = false;
    bool at_end_ = false;
};

}  // namespace gsim::simulation
