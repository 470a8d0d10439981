#include "motion/planner/planner.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "motion/klipper/klipper_model.h"
#include "motion/linuxcnc/linuxcnc_model.h"
#include "motion/lookahead/look_ahead.h"

namespace gsim::motion {

using rrs::Status;

namespace {

PlannerSetup validated(PlannerSetup setup) {
    if (auto error = setup.validate()) throw std::invalid_argument(*error);
    return setup;
}

std::unique_ptr<MotionModel> make_model(const PlannerSetup& setup, SegmentOutput& output) {
    switch (setup.controller.planner) {
        case rrs::PlannerKind::look_ahead: return std::make_unique<LookAhead>(setup, output);
        case rrs::PlannerKind::linuxcnc:
            return std::make_unique<LinuxcncModel>(setup, setup.controller, output);
        case rrs::PlannerKind::klipper: return std::make_unique<KlipperModel>(setup, output);
        case rrs::PlannerKind::rest_to_rest: break;
    }
    return nullptr;
}

}  // namespace

Planner::Planner(PlannerSetup setup, SegmentSink* sink)
    : machine_(validated(std::move(setup))),
      setup_(machine_),
      sink_(sink),
      axis_space_(AxisSpace::of(setup_)),
      queue_(setup_.queue_capacity),
      position_(rrs::JointPos::Zero(setup_.joint_count())),
      model_(make_model(setup_, output_)),
      tool_model_(std::make_unique<LookAhead>(setup_, output_)) {}

void Planner::restart() {
    queue_.clear();
    if (model_) model_->clear();
    if (path_sink_ != nullptr) path_sink_->forget();
    setup_ = machine_;
    active_machine_.reset();
    active_ramps_.reset();
    position_.setZero();
    tool_model_->clear();
    stopped_.reset();
    pending_.clear();
    conveyors_.clear();
    tracking_.reset();
    tracking_end_s_ = 0;
    independent_motion_.reset();
    events_.clear();
    end_s_ = 0;
    step_s_ = 0;
    step_target_ = kNoTarget;
    last_wait_s_ = 0;
    has_position_ = false;
}

// The models refer to setup_; their pending moves keep the limits that they were given.
void Planner::use(const MoveParameters& move_parameters) {
    if (move_parameters.machine == active_machine_ && move_parameters.ramps == active_ramps_) return;
    active_machine_ = move_parameters.machine;
    active_ramps_ = move_parameters.ramps;
    setup_ = move_parameters.machine ? *move_parameters.machine : machine_;
    if (move_parameters.ramps) activate_ramps(*move_parameters.ramps, machine_, setup_);
}

/// Targets that the model leaves out at the end are reached there.
void Planner::end_model() {
    if (!model_) return;
    model_->plan_to_standstill();
    pending_.mark_all_reached([this](rrs::TargetId id) { events_.reach(id, end_s_); });
}

void Planner::plan_to_standstill(bool waits) {
    end_model();
    if (!waits || end_s_ == last_wait_s_) return;
    const double dwell_s = setup_.controller.dwell_s;
    if (dwell_s > 0) append_dwell(kNoTarget, dwell_s);
    last_wait_s_ = end_s_;
}

// LinuxCNC's position loop delays by a period, and smooths over another one.
void Planner::plan_to_final_standstill() {
    plan_to_standstill();
    const double delay_s = 2 * setup_.controller.servo_period_s;
    if (end_s_ > 0 && delay_s > 0) append_dwell(kNoTarget, delay_s);
}

Segment& Planner::Output::begin(rrs::TargetId id) {
    Planner& planner = planner_;
    if (planner.queue_.free_slots() == 0 && planner.sink_ != nullptr && !planner.keeps_all_segments_)
        planner.emit_front();
    return planner.begin_segment(planner.queue_.next(), id);
}

void Planner::Output::finish() {
    Segment& segment = planner_.queue_.next();
    if (planner_.independent_motion_) planner_.independent_motion_->superimpose(segment);
    planner_.end_s_ = segment.end_s();
    planner_.queue_.push();
    if (!segment.reaches_target) return;
    const rrs::TargetId id = segment.target_id;
    planner_.pending_.reached(id, [&](rrs::TargetId passed) { planner_.events_.join(passed, id); });
}

double Planner::delivered_until_s() const {
    return queue_.empty() ? std::numeric_limits<double>::infinity() : queue_.front().start_s;
}

void Planner::flush() {
    if (stopped_) resume();
    plan_to_standstill();
    while (!queue_.empty()) emit_front();
}

// The segment leaves the queue before the sink sees it. It stays complete in its slot until a move takes the
// slot, and leaves only once even if the sink throws.
void Planner::emit_front() {
    const Segment& segment = queue_.front();
    events_.leave(queue_);
    queue_.pop();
    step_s_ = std::max(step_s_, segment.end_s());
    if (sink_ != nullptr) sink_->on_segment(segment);
}

Planner::Step Planner::step(double interpolation_s) {
    const double from_s = step_s_;
    const double known_s = events_.known_until_s(pending_, queue_, end_s_).value_or(end_s_);
    if (from_s + interpolation_s > known_s) plan_to_standstill();
    Step step;
    if (queue_.empty()) step.end = Step::StepEnd::at_end;
    step_s_ = std::min(from_s + interpolation_s, end_s_);
    events_.step(from_s, step_s_, queue_);
    step.joints = stopped_ ? stopped_->position : position_at_end();
    while (!queue_.empty() && queue_.front().end_s() <= step_s_) {
        step_target_ = queue_.front().target_id;
        if (queue_.front().reaches_target) step.end = Step::StepEnd::target_reached;
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

rrs::TargetId Planner::current_target() const {
    if (!queue_.empty()) return queue_.front().target_id;
    if (stopped_ && !stopped_->remainder.empty()) return stopped_->remainder.front().target_id;
    return pending_.first().value_or(kNoTarget);
}

rrs::JointPos Planner::standstill_position() const {
    return buffers_moves() ? model_->end_position_of(position_) : position_;
}

}  // namespace gsim::motion
