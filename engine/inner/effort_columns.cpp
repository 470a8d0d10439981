#include "engine/inner/effort_columns.h"

#include <utility>

#include "runtime/dynamics/segment_efforts.h"

namespace gsim::engine {

namespace {

using dynamics::EffortSample;

class EffortsOut : public simulation::RunOutput {
  public:
    EffortsOut(TakeEfforts take, const dynamics::Dynamics& dynamics)
        : take_(std::move(take)), segments_(dynamics) {}

    using simulation::RunOutput::take;
    void take(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        for (const EffortSample& sample : segments_.samples(segment))
            put(sample, segment.start_s, info.place.line);
        if (columns_.t_s.size() >= kColumnChunk) hand_out();
    }
    void end(double /*end_s*/) override { hand_out(); }

  private:
    void put(const EffortSample& sample, double start_s, std::uint32_t line) {
        columns_.t_s.push_back(start_s + sample.t_s);
        columns_.line.push_back(line);
        columns_.power_w.push_back(static_cast<float>(sample.powers_w.sum()));
        for (const double effort : sample.efforts) columns_.efforts.push_back(static_cast<float>(effort));
    }

    void hand_out() {
        if (columns_.t_s.empty()) return;
        take_(columns_);
        columns_ = {};
    }

    TakeEfforts take_;
    dynamics::SegmentEfforts segments_;
    EffortColumns columns_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> hand_out_efforts(TakeEfforts take,
                                                        const dynamics::Dynamics& dynamics) {
    return std::make_unique<EffortsOut>(std::move(take), dynamics);
}

}  // namespace gsim::engine
