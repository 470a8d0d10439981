#pragma once

#include <vector>

#include "motion/path/path_sink.h"

namespace gsim::simulation {

/// Distributor of one input to several sinks.
class PathSinks final : public motion::PathSink {
  public:
    /// `sink` outlives this.
    void add(motion::PathSink& sink) { sinks_.push_back(&sink); }

    void on_programmed_move(const motion::PathMove& move) override {
        for (motion::PathSink* sink : sinks_) sink->on_programmed_move(move);
    }
    void discard_last_move() override {
        for (motion::PathSink* sink : sinks_) sink->discard_last_move();
    }
    void forget() override {
        for (motion::PathSink* sink : sinks_) sink->forget();
    }

  private:
    std::vector<motion::PathSink*> sinks_;
};

}  // namespace gsim::simulation
