#include "engine/src/run/effort_columns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "motion/dynamics/segment_efforts.h"
#include "runtime/monitors/effort_watch.h"

namespace gsim::engine {

namespace {

using dynamics::EffortSample;

constexpr double kOff = 0.002;        // of the highest so far: straight lines are as good as a picture needs
constexpr double kShortest_s = 1e-6;  // between instants; nearer ones are the sides of a jump
constexpr int kMostHalvings = 4;

class EffortsOut : public simulation::RunOutput {
  public:
    EffortsOut(TakeEfforts take, const machine::Machine& machine, const dynamics::Dynamics& dynamics)
        : take_(std::move(take)),
          machine_(machine),
          segments_(dynamics),
          highest_(rrs::JointPos::Zero(dynamics.joint_count())) {}

    using simulation::RunOutput::take;
    void take(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        line_ = info.place.line;
        std::vector<EffortSample> samples = segments_.samples(segment);
        if (samples.size() == 1) {  // standstill: constant everywhere
            samples.push_back(samples.front());
            samples.front().t_s = 0;
            samples.back().t_s = segment.duration_s;
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (i > 0) put_between(segment, samples[i - 1], samples[i], kMostHalvings);
            put(samples[i], segment.start_s);
        }
        if (columns_.t_s.size() >= kColumnChunk) hand_out();
    }
    void end(double /*end_s*/) override { hand_out(); }

  private:
    /// Adds the instants that are required to keep straight lines accurate.
    void put_between(const motion::Segment& segment, const EffortSample& from, const EffortSample& to,
                     int halvings) {
        if (halvings == 0 || to.t_s - from.t_s < kShortest_s) return;
        const EffortSample middle = segments_.at(segment, (from.t_s + to.t_s) / 2);
        const double power_w = middle.powers_w.sum() - (from.powers_w.sum() + to.powers_w.sum()) / 2;
        const rrs::JointPos efforts = middle.efforts - (from.efforts + to.efforts) / 2;
        const bool straight = std::abs(power_w) <= kOff * highest_w_ &&
                              (efforts.cwiseAbs().array() <= kOff * highest_.array()).all();
        if (straight) return;
        put_between(segment, from, middle, halvings - 1);
        put(middle, segment.start_s);
        put_between(segment, middle, to, halvings - 1);
    }

    void put(const EffortSample& sample, double start_s) {
        const double power_w = sample.powers_w.sum();
        highest_w_ = std::max(highest_w_, std::abs(power_w));
        highest_ = highest_.cwiseMax(sample.efforts.cwiseAbs());
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

    void hand_out() {
        if (columns_.t_s.empty()) return;
        take_(columns_);
        columns_ = {};
    }

    TakeEfforts take_;
    const machine::Machine& machine_;
    dynamics::SegmentEfforts segments_;
    std::uint32_t line_ = 0;
    rrs::JointPos highest_;  // so far, of each joint,
    double highest_w_ = 0;   // and of the power
    EffortColumns columns_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> hand_out_efforts(TakeEfforts take, const machine::Machine& machine,
                                                        const dynamics::Dynamics& dynamics) {
    return std::make_unique<EffortsOut>(std::move(take), machine, dynamics);
}

}  // namespace gsim::engine
