#pragma once

#include <string>
#include <vector>

#include "runtime/motion_sources/motion_observer.h"

namespace gsim::simulation {

/// Stored requests of a run to its controller.
class MotionLog final : public MotionObserver {
  public:
    void stands_at(const rrs::JointPos& joints) override { start_ = joints; }
    void asked(const MotionAsk& ask) override { asks_.push_back(ask); }
    void untold(std::string_view why) override {
        if (gap_.empty()) gap_ = why;
    }
    void ended() override {}

    const rrs::JointPos& start() const { return start_; }
    const std::vector<MotionAsk>& asks() const { return asks_; }
    /// Returns why this is not everything that the motion depends on; empty: it is.
    const std::string& gap() const { return gap_; }

  private:
    rrs::JointPos start_;
    std::vector<MotionAsk> asks_;
    std::string gap_;
};

}  // namespace gsim::simulation
