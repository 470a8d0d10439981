#include "runtime/motion_sources/step_segments.h"

#include <cmath>

namespace gsim::simulation {

namespace {

constexpr double kPositionTolerance = 1e-6;  // mm or rad: positions at one instant may differ by rounding

}  // namespace

StepSegments::StepSegments(int joint_count, const std::array<int, 3>& position_joints,
                           motion::SegmentSink& sink)
    : position_joints_(position_joints), sink_(sink), position_(rrs::JointPos::Zero(joint_count)) {}

void StepSegments::add_step(const rrs::JointPos& joints, double elapsed_s, rrs::TargetId target) {
    fill_segment(joints, elapsed_s, target);
    sink_.on_segment(segment_);
    time_s_ = segment_.end_s();
    position_ = joints;
}

std::optional<std::string> StepSegments::add_instant(const rrs::JointPos& joints) {
    if ((joints - position_).cwiseAbs().maxCoeff() > kPositionTolerance)
        return "responded to GetNextStep with a jump: a joint moved in no time";
    position_ = joints;
    return std::nullopt;
}

void StepSegments::fill_segment(const rrs::JointPos& joints, double elapsed_s, rrs::TargetId target) {
    const rrs::JointPos displacement = joints - position_;
    double square_mm2 = 0;
    for (const int joint : position_joints_)
        square_mm2 += joint < 0 ? 0 : displacement[joint] * displacement[joint];
    segment_.target_id = target;
    segment_.start_s = time_s_;
    segment_.duration_s = elapsed_s;
    segment_.length_mm = std::sqrt(square_mm2);
    segment_.start = position_;
    segment_.end = joints;
    segment_.position_joints = position_joints_;
    segment_.limited_by = {.kind = motion::LimitKind::unknown};
    const double length = segment_.length_mm > 0 ? segment_.length_mm : displacement.norm();
    segment_.kind = length > 0 ? motion::SegmentKind::linear : motion::SegmentKind::rest;
    const motion::LawSection section{
        .duration_s = elapsed_s, .s0 = 0, .v0 = length / elapsed_s, .a0 = 0, .jerk = 0};
    segment_.master = motion::TimeLaw::from_sections({&section, 1});
}

}  // namespace gsim::simulation
