#include "motion/planner/timeline.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace gsim::motion {

Timeline::Timeline(const ActiveMachine& machine, SegmentSink* sink)
    : machine_(machine), sink_(sink), queue_(machine.setup().queue_capacity) {}

Segment& Timeline::begin(rrs::TargetId id) {
    if (queue_.free_slots() == 0 && sink_ != nullptr && !keeps_all_segments_) emit_front();
    return begin_reserved(id);
}

Segment& Timeline::begin_reserved(rrs::TargetId id) {
    Segment& slot = queue_.next();
    slot.target_id = id;
    slot.start_s = end_s_;
    slot.position_joints = machine_.setup().position_joints;
    slot.clear_followers();
    slot.reaches_target = true;
    slot.master_limits = {};
    slot.limited_by = {};
    slot.superimposed.reset();
    slot.orientation.reset();
    slot.deviation_mm = 0;
    slot.uncoordinated = 0;
    slot.path_deviation = PathDeviation::no;
    return slot;
}

void Timeline::finish() {
    Segment& segment = queue_.next();
    if (independent_motion_) independent_motion_->superimpose(segment);
    end_s_ = segment.end_s();
    queue_.push();
    if (!segment.reaches_target) return;
    const rrs::TargetId id = segment.target_id;
    pending_.reached(id, [&](rrs::TargetId passed) { events_.join(passed, id); });
}

void Timeline::append(Segment&& segment) {
    queue_.next() = std::move(segment);
    finish();
}

PlanResult Timeline::reserve(std::size_t segments) {
    while (queue_.free_slots() < segments && !keeps_all_segments_) {
        if (sink_ == nullptr) {
            return make_plan_error(
                rrs::Status::RRS_QUEUE_FULL,
                fmt::format("{} targets are pending; call GetNextStep before setting more.",
                            machine_.setup().queue_capacity));
        }
        emit_front();
    }
    return {};
}

void Timeline::flush() {
    while (!queue_.empty()) emit_front();
}

// The segment leaves the queue before the sink sees it. It stays complete in its slot until a move takes the
// slot, and leaves only once even if the sink throws.
void Timeline::emit_front() {
    const Segment& segment = queue_.front();
    events_.leave(queue_);
    queue_.pop();
    step_s_ = std::max(step_s_, segment.end_s());
    if (sink_ != nullptr) sink_->on_segment(segment);
}

void Timeline::restart() {
    queue_.clear();
    pending_.clear();
    events_.clear();
    independent_motion_.reset();
    end_s_ = 0;
    step_s_ = 0;
    step_target_ = kNoTarget;
}

double Timeline::delivered_until_s() const {
    return queue_.empty() ? std::numeric_limits<double>::infinity() : queue_.front().start_s;
}

// Targets that the model leaves out at the end are reached there.
void Timeline::mark_pending_reached() {
    pending_.mark_all_reached([this](rrs::TargetId id) { events_.reach(id, end_s_); });
}

double Timeline::known_until_s() const {
    return events_.known_until_s(pending_, queue_, end_s_).value_or(end_s_);
}

MotionStep Timeline::step(double interpolation_s, const rrs::JointPos& end_position) {
    const double from_s = step_s_;
    MotionStep step;
    if (queue_.empty()) step.end = MotionStep::End::at_end;
    step_s_ = std::min(from_s + interpolation_s, end_s_);
    events_.step(from_s, step_s_, queue_);
    step.joints = end_position;
    while (!queue_.empty() && queue_.front().end_s() <= step_s_) {
        step_target_ = queue_.front().target_id;
        if (queue_.front().reaches_target) step.end = MotionStep::End::target_reached;
        emit_front();
    }
    if (!queue_.empty()) {
        const Segment& front = queue_.front();
        step.joints = front.position_at(step_s_ - front.start_s);
        if (step_s_ > front.start_s) step_target_ = front.target_id;
    }
    step.elapsed_s = step_s_ - from_s;
    return step;
}

void Timeline::advance_step_clock(double time_s) {
    step_s_ = std::max(step_s_, time_s);
}

std::vector<Segment> Timeline::cut_at_step_clock() {
    std::vector<Segment> segments;
    for (; !queue_.empty(); queue_.pop()) segments.push_back(queue_.front());
    end_s_ = step_s_;
    return segments;
}

void Timeline::release_passed() {
    while (!queue_.empty() && queue_.front().end_s() <= step_s_) emit_front();
}

}  // namespace gsim::motion
