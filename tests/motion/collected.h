#pragma once

#include <deque>

#include "motion/planner/motion_model.h"

namespace gsim::motion {

/// Keeps the segments that a model makes, on one clock.
class Collected final : public SegmentOutput {
  public:
    explicit Collected(std::array<int, 3> position_joints = {0, 1, 2}) : position_joints_(position_joints) {}

    Segment& begin(rrs::TargetId id) override {
        open_ = {};
        open_.target_id = id;
        open_.start_s = end_s_;
        open_.position_joints = position_joints_;
        return open_;
    }
    void finish() override {
        end_s_ = open_.end_s();
        segments.push_back(open_);
    }
    double time_s() const override { return end_s_; }

    std::deque<Segment> segments;

  private:
    std::array<int, 3> position_joints_;
    Segment open_;
    double end_s_ = 0;
};

}  // namespace gsim::motion
