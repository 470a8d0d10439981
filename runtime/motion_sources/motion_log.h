#pragma once

#include <string>
#include <vector>

#include "runtime/motion_sources/motion_observer.h"

namespace gsim::simulation {

/// Stored requests of a run to its controller.
class MotionLog final : public MotionObserver {
  public:
    void on_start_position(const rrs::JointPos& joints) override { start_ = joints; }
    void on_request(const MotionRequest& request) override { requests_.push_back(request); }
    void on_unrecordable(std::string_view reason) override {
        if (incomplete_reason_.empty()) incomplete_reason_ = reason;
    }
    void ended() override {}

    const rrs::JointPos& start() const { return start_; }
    const std::vector<MotionRequest>& requests() const { return requests_; }
    /// Returns why this is not everything that the motion depends on; empty: it is.
    const std::string& incomplete_reason() const { return incomplete_reason_; }

  private:
    rrs::JointPos start_;
    std::vector<MotionRequest> requests_;
    std::string incomplete_reason_;
};

}  // namespace gsim::simulation
