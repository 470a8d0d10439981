#include "motion/dynamics/servo_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "motion/dynamics/law_ends.h"

namespace gsim::dynamics {

using motion::JointState;
using motion::Segment;

namespace {

constexpr double kMinStep_s = 1e-12;
constexpr double kEndInset = 1e-9;           // of a step: how far its ends are looked at from inside
constexpr double kLinearBelow_s = 2e-5;      // slopes of so short steps are rounding
constexpr double kSettledTolerance = 1e-10;  // mm or rad: less is left of a change
constexpr double kMinOrientationSteps = 64;  // steps of a great circle

double turn_rad(const Segment& segment) {
    double turn = segment.kind == motion::SegmentKind::circular ? segment.arc.sweep_rad : 0;
    if (segment.superimposed) turn += turn_rad(*segment.superimposed);
    return turn;
}

bool has_orientation_path(const Segment& segment) {
    return segment.orientation || (segment.superimposed && has_orientation_path(*segment.superimposed));
}

bool is_proportional(const Segment& segment) {
    return segment.kind != motion::SegmentKind::circular && !segment.superimposed && !segment.orientation &&
           segment.followers().empty() && !segment.is_uncoordinated();
}

}  // namespace

ServoMotion::ServoMotion(std::vector<ServoLoop> loops, std::vector<bool> is_rotary, double step_s)
    : loops_(std::move(loops)),
      is_rotary_(std::move(is_rotary)),
      step_s_(step_s),
      ends_(loops_.size()),
      history_(loops_) {}

void ServoMotion::begin(const rrs::JointPos& start) {
    history_.begin(start);
    standstill_.start = standstill_.end = start;
    for (std::size_t joint = 0; joint < ends_.size(); ++joint)
        ends_[joint] = {start[static_cast<Eigen::Index>(joint)], 0, {}};
}

void ServoMotion::enter(const Segment& segment, const StepHandler& on_step) {
    go_to(segment.start_s, on_step);
    segment_ = &segment;
    segment_time_s_ = 0;
    now_s_ = std::max(now_s_, segment.start_s);
    part_ = 0;
    part_begun_ = false;
    part_ends_s_.clear();
    add_law_ends(segment, part_ends_s_);
    part_ends_s_.push_back(segment.duration_s);
    std::sort(part_ends_s_.begin(), part_ends_s_.end());
    const double turn = turn_rad(segment);
    double steps = turn > 0 ? std::ceil(turn / kMaxRotation_rad * kStep_s / step_s_) : 0;
    if (has_orientation_path(segment)) steps += kMinOrientationSteps;
    curve_step_s_ = steps > 0 ? segment.duration_s / steps : std::numeric_limits<double>::infinity();
    set_points_.straight = is_proportional(segment);
    set_points_.begins_segment = true;
}

void ServoMotion::leave(const StepHandler& on_step) {
    go_to(segment_->end_s(), on_step);
    standstill_.start = standstill_.end = segment_->end_position();
    now_s_ = std::max(now_s_, segment_->end_s());
    segment_ = nullptr;
}

void ServoMotion::go_to(double t_s, const StepHandler& on_step) {
    if (segment_ == nullptr) {  // between two segments the axes are at standstill
        if (t_s - now_s_ <= kMinStep_s * std::max(1.0, t_s)) return;
        standstill_.start_s = now_s_;
        standstill_.duration_s = t_s - now_s_;
        enter(standstill_, on_step);
        leave(on_step);
        return;
    }
    const double to_s = std::min(t_s - segment_->start_s, segment_->duration_s);
    while (to_s - segment_time_s_ > kMinStep_s) {
        while (part_ < part_ends_s_.size() && part_ends_s_[part_] - segment_time_s_ <= kMinStep_s) {
            ++part_;
            part_begun_ = false;
        }
        if (!part_begun_) begin_part();
        const double path_part_end_s =
            part_ < part_ends_s_.size() ? part_ends_s_[part_] : std::numeric_limits<double>::infinity();
        make_step(next_step_s(std::min(path_part_end_s, to_s) - segment_time_s_), on_step);
    }
}

/// Returns the state at an end of a part of the segment, as it is inside, because accelerations jump at the
/// ends.
JointState ServoMotion::state_inside(double from_s, double to_s, bool at_end) const {
    const double inset_s = kEndInset * (to_s - from_s);
    JointState state = segment_->at(at_end ? to_s - inset_s : from_s + inset_s);
    state.position += (at_end ? inset_s : -inset_s) * state.velocity;
    return state;
}

void ServoMotion::begin_part() {
    const double end_s = part_ < part_ends_s_.size() ? std::min(part_ends_s_[part_], segment_->duration_s)
                                                     : segment_->duration_s;
    set_points_.from = state_inside(segment_time_s_, end_s, false);
    const JointState last = state_inside(segment_time_s_, end_s, true);
    part_constant_ = std::isinf(curve_step_s_) && set_points_.from.acceleration.isZero(0) &&
                     last.acceleration.isZero(0) && set_points_.from.velocity == last.velocity;
    part_begun_ = true;
}

bool ServoMotion::is_steady() const {
    if (!part_constant_) return false;
    for (std::size_t joint = 0; joint < loops_.size(); ++joint) {
        if (joint_step(joint, 0).error.transient_bound() > kSettledTolerance) return false;
    }
    return true;
}

/// Returns the length of the next step within the remaining time.
double ServoMotion::next_step_s(double remaining_s) const {
    double angular_speed_rad_s = 0;
    for (std::size_t joint = 0; joint < is_rotary_.size(); ++joint) {
        if (is_rotary_[joint])
            angular_speed_rad_s += std::abs(set_points_.from.velocity[static_cast<Eigen::Index>(joint)]);
    }
    double step_s = remaining_s > step_s_ && !is_steady() ? step_s_ : remaining_s;
    if (angular_speed_rad_s * step_s > kMaxRotation_rad) step_s = kMaxRotation_rad / angular_speed_rad_s;
    step_s = std::max(std::min(step_s, curve_step_s_), segment_->duration_s / kMaxSteps);
    return step_s < remaining_s ? remaining_s / std::ceil(remaining_s / step_s) : remaining_s;
}

/// Returns the further motion of a joint, from `set_points_.from`; without a duration at that speed. If a set
/// point or its speed jumps, the position does not. Its speed does not either, except for the effect of
/// acceleration feed-forward.
ServoHistory::JointStep ServoMotion::joint_step(std::size_t joint, double duration_s) const {
    const auto i = static_cast<Eigen::Index>(joint);
    ServoHistory::JointStep step{
        .at = set_points_.from.position[i], .speed = {set_points_.from.velocity[i], 0, 0, 0}, .error = {}};
    if (duration_s > 0) {
        const double from = set_points_.from.acceleration[i];
        const double to = set_points_.to.acceleration[i];
        const double mean = (set_points_.to.velocity[i] - set_points_.from.velocity[i]) / duration_s;
        if (duration_s < kLinearBelow_s) {
            step.speed[1] = mean;
        } else {
            step.speed[1] = from;
            step.speed[2] = (3 * mean - 2 * from - to) / duration_s;
            step.speed[3] = (from + to - 2 * mean) / (duration_s * duration_s);
        }
    }
    const ServoLoop& loop = loops_[joint];
    const JointEnd& end = ends_[joint];
    const double jump = (1 - loop.acceleration_share) * (step.speed[0] - end.speed);
    step.error =
        ServoStep(loop, step.speed, {end.error.value + step.at - end.set_point, end.error.rate + jump});
    return step;
}

void ServoMotion::make_step(double duration_s, const StepHandler& on_step) {
    const double to_s = segment_time_s_ + duration_s;
    set_points_.start_s = segment_->start_s + segment_time_s_;
    set_points_.duration_s = duration_s;
    set_points_.to = part_constant_ ? set_points_.from : state_inside(segment_time_s_, to_s, true);
    if (part_constant_) set_points_.to.position += duration_s * set_points_.from.velocity;
    ServoHistory::Step step = history_.release_spare();
    step.start_s = set_points_.start_s;
    step.duration_s = duration_s;
    step.joints.resize(loops_.size());
    for (std::size_t joint = 0; joint < loops_.size(); ++joint) {
        const ServoHistory::JointStep joint_state = step.joints[joint] = joint_step(joint, duration_s);
        ends_[joint] = {joint_state.set_point(duration_s), joint_state.speed_at(duration_s),
                        joint_state.error.at(duration_s)};
    }
    history_.add(std::move(step));
    segment_time_s_ = to_s;
    now_s_ = segment_->start_s + segment_time_s_;
    if (on_step) on_step(set_points_);
    set_points_.from = set_points_.to;
    set_points_.begins_segment = false;
}

}  // namespace gsim::dynamics
