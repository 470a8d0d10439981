#pragma once

#include <vector>

#include "motion/path/way_sink.h"

namespace gsim::simulation {

/// Distributor of one input to several sinks.
class WaySinks final : public motion::WaySink {
  public:
    /// `sink` outlives this.
    void add(motion::WaySink& sink) { sinks_.push_back(&sink); }

    void programmed(const motion::PathMove& move) override {
        for (motion::WaySink* sink : sinks_) sink->programmed(move);
    }
    void take_back() override {
        for (motion::WaySink* sink : sinks_) sink->take_back();
    }
    void forget() override {
        for (motion::WaySink* sink : sinks_) sink->forget();
    }

  private:
    std::vector<motion::WaySink*> sinks_;
};

}  // namespace gsim::simulation
