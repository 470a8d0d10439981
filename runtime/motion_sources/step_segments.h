#pragma once

#include <array>
#include <optional>
#include <string>

#include "motion/segment/segment.h"

namespace gsim::simulation {

/// Segments of the steps of a module: straight, at constant speed. The motion of a module between two steps
/// is unknown, so the joints are taken to move evenly.
class StepSegments {
  public:
    /// `position_joints` carry x, y and z (-1: none). `sink` must outlive this.
    StepSegments(int joint_count, const std::array<int, 3>& position_joints, motion::SegmentSink& sink);

    /// Sets the position where the next step begins.
    void set_position(const rrs::JointPos& joints) { position_ = joints; }
    /// Passes the segment of a step that takes time (`elapsed_s` > 0) to the sink.
    void add_step(const rrs::JointPos& joints, double elapsed_s, rrs::TargetId target);
    /// Sets the position after a step without time. Returns an error, which continues a message that begins
    /// with the module's name, if a joint has moved by more than rounding.
    std::optional<std::string> add_instant(const rrs::JointPos& joints);

    /// Returns the end of the last step.
    const rrs::JointPos& position() const { return position_; }
    double time_s() const { return time_s_; }
    /// Returns the segment of the last step that took time.
    const motion::Segment& segment() const { return segment_; }

  private:
    void fill_segment(const rrs::JointPos& joints, double elapsed_s, rrs::TargetId target);

    std::array<int, 3> position_joints_;
    motion::SegmentSink& sink_;
    motion::Segment segment_;
    rrs::JointPos position_;
    double time_s_ = 0;
};

}  // namespace gsim::simulation
