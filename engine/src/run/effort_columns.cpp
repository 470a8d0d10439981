#include "engine/src/run/effort_columns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "motion/dynamics/segment_efforts.h"
#include "runtime/monitors/effort_monitor.h"

namespace gsim::engine {

namespace {

using dynamics::EffortSample;

constexpr double kChordTolerance =
    0.002;                            // of the highest so far: straight lines are as good as a picture needs
constexpr double kShortest_s = 1e-6;  // between instants; nearer ones are the sides of a jump
constexpr int kMaxHalvings = 4;

class EffortsOutput : public simulation::RunOutput {
  public:
    EffortsOutput(EffortsHandler on_segment, const machine::Machine& machine,
                  const dynamics::Dynamics& dynamics)
        : handler_(std::move(on_segment)),
          machine_(machine),
          segments_(dynamics),
          max_efforts_(rrs::JointPos::Zero(dynamics.joint_count())) {}

    void on_segment(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        line_ = info.location.line;
        std::vector<EffortSample> samples = segments_.samples(segment);
        if (samples.size() == 1) {  // standstill: constant everywhere
            samples.push_back(samples.front());
            samples.front().t_s = 0;
            samples.back().t_s = segment.duration_s;
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (i > 0) insert_between(segment, samples[i - 1], samples[i], kMaxHalvings);
            append(samples[i], segment.start_s);
        }
        if (columns_.t_s.size() >= kColumnChunk) deliver();
    }
    void end(double /*end_s*/) override { deliver(); }

  private:
    /// Adds the instants that are required to keep straight lines accurate.
    void insert_between(const motion::Segment& segment, const EffortSample& from, const EffortSample& to,
                        int halvings) {
        if (halvings == 0 || to.t_s - from.t_s < kShortest_s) return;
        const EffortSample middle = segments_.at(segment, (from.t_s + to.t_s) / 2);
        const double power_w = middle.powers_w.sum() - (from.powers_w.sum() + to.powers_w.sum()) / 2;
        const rrs::JointPos efforts = middle.efforts - (from.efforts + to.efforts) / 2;
        const bool straight = std::abs(power_w) <= kChordTolerance * max_power_w_ &&
                              (efforts.cwiseAbs().array() <= kChordTolerance * max_efforts_.array()).all();
        if (straight) return;
        insert_between(segment, from, middle, halvings - 1);
        append(middle, segment.start_s);
        insert_between(segment, middle, to, halvings - 1);
    }

    void append(const EffortSample& sample, double start_s) {
        const double power_w = sample.powers_w.sum();
        max_power_w_ = std::max(max_power_w_, std::abs(power_w));
        max_efforts_ = max_efforts_.cwiseMax(sample.efforts.cwiseAbs());
        columns_.t_s.push_back(start_s + sample.t_s);
        columns_.line.push_back(line_);
        columns_.power_w.push_back(static_cast<float>(power_w));
        for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
            const auto joint = static_cast<Eigen::Index>(i);
            const machine::Axis& axis = machine_.axes[i];
            const double speed = simulation::axis_speed(axis, sample.motion.velocity[joint]);
            columns_.efforts.push_back(static_cast<float>(sample.efforts[joint]));
            columns_.motor_peaks.push_back(static_cast<float>(simulation::motor_peak(axis.drive, speed)));
        }
    }

    void deliver() {
        if (columns_.t_s.empty()) return;
        handler_(columns_);
        columns_ = {};
    }

    EffortsHandler handler_;
    const machine::Machine& machine_;
    dynamics::SegmentEfforts segments_;
    std::uint32_t line_ = 0;
    rrs::JointPos max_efforts_;  // so far, of each joint,
    double max_power_w_ = 0;     // and of the power
    EffortColumns columns_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> make_efforts_output(EffortsHandler on_segment,
                                                           const machine::Machine& machine,
                                                           const dynamics::Dynamics& dynamics) {
    return std::make_unique<EffortsOutput>(std::move(on_segment), machine, dynamics);
}

}  // namespace gsim::engine
