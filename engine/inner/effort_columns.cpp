#include "engine/inner/effort_columns.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/dynamics/segment_efforts.h"
#include "runtime/simulation/effort_watch.h"

namespace gsim::engine {

namespace {

using dynamics::EffortSample;

class EffortsOut : public simulation::RunOutput {
  public:
    EffortsOut(TakeEfforts take, const machine::Machine& machine, const dynamics::Dynamics& dynamics)
        : take_(std::move(take)), machine_(machine), segments_(dynamics) {}

    using simulation::RunOutput::take;
    void take(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        const std::vector<EffortSample> samples = segments_.samples(segment);
        const double start_s = segment.start_s;
        if (samples.size() == 1) {  // of a rest, all of which is alike
            put(samples.front(), start_s, info.place.line);
            put(samples.front(), start_s + segment.duration_s, info.place.line);
        } else {
            for (const EffortSample& sample : samples) put(sample, start_s + sample.t_s, info.place.line);
        }
        if (columns_.t_s.size() >= kColumnChunk) hand_out();
    }
    void end(double /*end_s*/) override { hand_out(); }

  private:
    void put(const EffortSample& sample, double t_s, std::uint32_t line) {
        columns_.t_s.push_back(t_s);
        columns_.line.push_back(line);
        columns_.power_w.push_back(static_cast<float>(sample.powers_w.sum()));
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
    EffortColumns columns_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> hand_out_efforts(TakeEfforts take, const machine::Machine& machine,
                                                        const dynamics::Dynamics& dynamics) {
    return std::make_unique<EffortsOut>(std::move(take), machine, dynamics);
}

}  // namespace gsim::engine
