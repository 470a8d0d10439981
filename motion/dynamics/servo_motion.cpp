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

constexpr double kLeastStep_s = 1e-12;
constexpr double kEndInside = 1e-9;      // of a step: how far its ends are looked at from inside
constexpr double kLinearBelow_s = 2e-5;  // slopes of so short steps are rounding
constexpr double kSettled = 1e-10;       // mm or rad: less is left of a change
constexpr double kLeastOfHeads = 64;     // steps of a great circle
constexpr std::size_t kFewest = 3;       // steps that are kept,
constexpr std::size_t kMost = 100'000;   // and the max, whatever the delay

double turn_rad(const Segment& segment) {
    double turn = segment.kind == motion::SegmentKind::circular ? segment.arc.sweep_rad : 0;
    if (segment.beside) turn += turn_rad(*segment.beside);
    return turn;
}

bool has_head_way(const Segment& segment) {
    return segment.orientation || (segment.beside && has_head_way(*segment.beside));
}

bool in_proportion(const Segment& segment) {
    return segment.kind != motion::SegmentKind::circular && !segment.beside && !segment.orientation &&
           segment.followers().empty() && !segment.joints_go_apart();
}

}  // namespace

ServoMotion::ServoMotion(std::vector<ServoLoop> loops, std::vector<bool> turns, double step_s)
    : loops_(std::move(loops)), turns_(std::move(turns)), step_s_(step_s), ends_(loops_.size()) {
    for (const ServoLoop& loop : loops_) longest_delay_s_ = std::max(longest_delay_s_, loop.delay_s);
}

void ServoMotion::begin(const rrs::JointPos& start) {
    start_ = rest_.start = rest_.end = start;
    for (std::size_t joint = 0; joint < ends_.size(); ++joint)
        ends_[joint] = {start[static_cast<Eigen::Index>(joint)], 0, {}};
}

void ServoMotion::enter(const Segment& segment, const Look& look) {
    go_to(segment.start_s, look);
    segment_ = &segment;
    at_s_ = 0;
    now_s_ = std::max(now_s_, segment.start_s);
    part_ = 0;
    part_entered_ = false;
    part_ends_s_.clear();
    add_law_ends(segment, part_ends_s_);
    part_ends_s_.push_back(segment.duration_s);
    std::sort(part_ends_s_.begin(), part_ends_s_.end());
    const double turn = turn_rad(segment);
    double steps = turn > 0 ? std::ceil(turn / kMostTurn_rad * kStep_s / step_s_) : 0;
    if (has_head_way(segment)) steps += kLeastOfHeads;
    curve_step_s_ = steps > 0 ? segment.duration_s / steps : std::numeric_limits<double>::infinity();
    set_.straight = in_proportion(segment);
    set_.begins_segment = true;
}

void ServoMotion::leave(const Look& look) {
    go_to(segment_->end_s(), look);
    rest_.start = rest_.end = segment_->end_position();
    now_s_ = std::max(now_s_, segment_->end_s());
    segment_ = nullptr;
}

void ServoMotion::go_to(double t_s, const Look& look) {
    if (segment_ == nullptr) {  // between two segments the axes are at standstill
        if (t_s - now_s_ <= kLeastStep_s * std::max(1.0, t_s)) return;
        rest_.start_s = now_s_;
        rest_.duration_s = t_s - now_s_;
        enter(rest_, look);
        leave(look);
        return;
    }
    const double to_s = std::min(t_s - segment_->start_s, segment_->duration_s);
    while (to_s - at_s_ > kLeastStep_s) {
        while (part_ < part_ends_s_.size() && part_ends_s_[part_] - at_s_ <= kLeastStep_s) {
            ++part_;
            part_entered_ = false;
        }
        if (!part_entered_) enter_part();
        const double part_end_s =
            part_ < part_ends_s_.size() ? part_ends_s_[part_] : std::numeric_limits<double>::infinity();
        make_step(step_s_from(std::min(part_end_s, to_s) - at_s_), look);
    }
}

/// Returns the state at an end of a part of the segment, as it is inside, because accelerations jump at the
/// ends.
JointState ServoMotion::state_inside(double from_s, double to_s, bool at_end) const {
    const double inside_s = kEndInside * (to_s - from_s);
    JointState state = segment_->at(at_end ? to_s - inside_s : from_s + inside_s);
    state.position += (at_end ? inside_s : -inside_s) * state.velocity;
    return state;
}

void ServoMotion::enter_part() {
    const double end_s = part_ < part_ends_s_.size() ? std::min(part_ends_s_[part_], segment_->duration_s)
                                                     : segment_->duration_s;
    set_.from = state_inside(at_s_, end_s, false);
    const JointState last = state_inside(at_s_, end_s, true);
    part_constant_ = std::isinf(curve_step_s_) && set_.from.acceleration.isZero(0) &&
                     last.acceleration.isZero(0) && set_.from.velocity == last.velocity;
    part_entered_ = true;
}

bool ServoMotion::is_steady() const {
    if (!part_constant_) return false;
    for (std::size_t joint = 0; joint < loops_.size(); ++joint) {
        if (joint_step(joint, 0).error.transient() > kSettled) return false;
    }
    return true;
}

/// Returns the length of the next step within the remaining time.
double ServoMotion::step_s_from(double left_s) const {
    double turning_rad_s = 0;
    for (std::size_t joint = 0; joint < turns_.size(); ++joint) {
        if (turns_[joint]) turning_rad_s += std::abs(set_.from.velocity[static_cast<Eigen::Index>(joint)]);
    }
    double step_s = left_s > step_s_ && !is_steady() ? step_s_ : left_s;
    if (turning_rad_s * step_s > kMostTurn_rad) step_s = kMostTurn_rad / turning_rad_s;
    step_s = std::max(std::min(step_s, curve_step_s_), segment_->duration_s / kMostSteps);
    return step_s < left_s ? left_s / std::ceil(left_s / step_s) : left_s;
}

/// Returns the further motion of a joint, from `set_.from`; without a duration at that speed. If a set point
/// or its speed jumps, the position does not. Its speed does not either, except for the effect of
/// acceleration feed-forward.
ServoMotion::JointStep ServoMotion::joint_step(std::size_t joint, double duration_s) const {
    const auto i = static_cast<Eigen::Index>(joint);
    JointStep step{.at = set_.from.position[i], .speed = {set_.from.velocity[i], 0, 0, 0}, .error = {}};
    if (duration_s > 0) {
        const double from = set_.from.acceleration[i];
        const double to = set_.to.acceleration[i];
        const double mean = (set_.to.velocity[i] - set_.from.velocity[i]) / duration_s;
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

void ServoMotion::make_step(double duration_s, const Look& look) {
    const double to_s = at_s_ + duration_s;
    set_.start_s = segment_->start_s + at_s_;
    set_.duration_s = duration_s;
    set_.to = part_constant_ ? set_.from : state_inside(at_s_, to_s, true);
    if (part_constant_) set_.to.position += duration_s * set_.from.velocity;
    Step step = std::move(spare_);
    step.start_s = set_.start_s;
    step.duration_s = duration_s;
    step.joints.resize(loops_.size());
    for (std::size_t joint = 0; joint < loops_.size(); ++joint) {
        const JointStep made = step.joints[joint] = joint_step(joint, duration_s);
        ends_[joint] = {made.set_point(duration_s), made.speed_at(duration_s), made.error.at(duration_s)};
    }
    keep(std::move(step));
    at_s_ = to_s;
    now_s_ = segment_->start_s + at_s_;
    if (look) look(set_);
    set_.from = set_.to;
    set_.begins_segment = false;
}

void ServoMotion::keep(Step step) {
    steps_.push_back(std::move(step));
    const auto reaches_back = [this] {
        return steps_[1].start_s <= steps_[steps_.size() - kFewest].start_s - longest_delay_s_;
    };
    while (steps_.size() > kFewest && (reaches_back() || steps_.size() > kMost)) {
        spare_ = std::move(steps_.front());
        steps_.pop_front();
    }
}

const ServoMotion::Step* ServoMotion::step_at(double t_s) const {
    if (steps_.empty()) return nullptr;
    if (t_s >= steps_.back().start_s) return &steps_.back();
    const auto above = std::upper_bound(steps_.begin(), steps_.end(), t_s,
                                        [](double at_s, const Step& step) { return at_s < step.start_s; });
    return above == steps_.begin() ? &steps_.front() : &*(above - 1);
}

rrs::JointPos ServoMotion::set_points(double t_s) const {
    const Step* step = step_at(t_s);
    if (step == nullptr) return start_;
    rrs::JointPos points(start_.size());
    const double in_s = std::clamp(t_s - step->start_s, 0.0, step->duration_s);
    for (std::size_t joint = 0; joint < loops_.size(); ++joint)
        points[static_cast<Eigen::Index>(joint)] = step->joints[joint].set_point(in_s);
    return points;
}

rrs::JointPos ServoMotion::places(double t_s) const {
    if (steps_.empty()) return start_;
    rrs::JointPos places(start_.size());
    for (std::size_t joint = 0; joint < loops_.size(); ++joint) {
        const double late_s = t_s - loops_[joint].delay_s;
        const Step* step = step_at(late_s);
        const double in_s = std::clamp(late_s - step->start_s, 0.0, step->duration_s);
        const JointStep& of = step->joints[joint];
        places[static_cast<Eigen::Index>(joint)] = of.set_point(in_s) - of.error.at(in_s).value;
    }
    return places;
}

}  // namespace gsim::dynamics
