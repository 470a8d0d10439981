#include "runtime/motion/planner.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "runtime/motion/linuxcnc/linuxcnc_model.h"
#include "runtime/motion/look_ahead.h"

namespace gsim::motion {

using rrs::Status;

namespace {

PlannerSetup valid(PlannerSetup setup) {
    if (auto trouble = setup.validate()) throw std::invalid_argument(*trouble);
    return setup;
}

std::unique_ptr<MotionModel> make_model(const PlannerSetup& setup, SegmentOutput& output) {
    switch (setup.controller.planner) {
        case rrs::PlannerKind::look_ahead: return std::make_unique<LookAhead>(setup, output);
        case rrs::PlannerKind::linuxcnc:
            return std::make_unique<LinuxcncModel>(setup, setup.controller, output);
        case rrs::PlannerKind::rest_to_rest: break;
    }
    return nullptr;
}

}  // namespace

DefaultPlanner::DefaultPlanner(PlannerSetup setup, SegmentSink* sink)
    : machine_(valid(std::move(setup))),
      setup_(machine_),
      sink_(sink),
      axis_space_(AxisSpace::of(setup_)),
      queue_(setup_.queue_capacity),
      programmed_(setup_.joint_count()),
      position_(rrs::JointPos::Zero(setup_.joint_count())),
      tip_turns_(tip_turns(setup_)),
      model_(make_model(setup_, output_)),
      tool_model_(std::make_unique<LookAhead>(setup_, output_)) {}

Status DefaultPlanner::Initialize() {
    start_over();
    initialized_ = true;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::Reset() {
    if (!initialized_) return not_initialized();
    start_over();
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::Terminate() {
    if (!initialized_) return not_initialized();
    start_over();
    initialized_ = false;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::GetMessage(std::string& message) {
    message = error_.message;
    return Status::RRS_SUCCESS;
}

void DefaultPlanner::start_over() {
    queue_.clear();
    if (model_) model_->clear();
    if (ways_ != nullptr) ways_->forget();
    programmed_ = Programmed(setup_.joint_count());
    setup_ = machine_;
    position_.setZero();
    via_.reset();
    tip_.reset();
    work_frames_ = {};
    selected_.reset();
    frames_before_.clear();
    machine_moved_s_ = 0;
    tip_turns_ = tip_turns(setup_);
    if (cell_ != nullptr) static_cast<void>(select_frames());
    tool_model_->clear();
    stopped_.reset();
    held_.clear();
    conveyors_.clear();
    tracked_.reset();
    conveyor_until_s_ = 0;
    object_ = ObjectMotion();
    object_frame_.reset();
    events_.clear();
    error_ = {};
    end_s_ = 0;
    step_s_ = 0;
    step_target_ = kNoTarget;
    waited_s_ = 0;
    has_position_ = false;
}

/// What the model leaves out at the end is reached there.
void DefaultPlanner::end_model() {
    if (!model_) return;
    model_->come_to_rest();
    held_.all_reached([this](rrs::TargetId id) { events_.reach(id, end_s_); });
}

void DefaultPlanner::come_to_rest(bool waits) {
    end_model();
    if (!waits || end_s_ == waited_s_) return;
    const double rest_s = setup_.controller.rest_s;
    if (rest_s > 0) append_rest(kNoTarget, rest_s);
    waited_s_ = end_s_;
}

// At the end: LinuxCNC's position loop delays by a period, and smooths over another one.
Status DefaultPlanner::ComeToRest(rrs::RestReason reason) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(reason);
    if (number < 0 || number > 2) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no reason {} to come to rest; 0 is a query, 1 a wait, 2 the end.", number));
    }
    come_to_rest(reason == rrs::RestReason::wait);
    const double delay_s = 2 * setup_.controller.servo_period_s;
    if (reason == rrs::RestReason::end && end_s_ > 0 && delay_s > 0) append_rest(kNoTarget, delay_s);
    return Status::RRS_SUCCESS;
}

void DefaultPlanner::end_program() {
    ComeToRest(rrs::RestReason::end);
    flush();
}

Segment& DefaultPlanner::Output::begin(rrs::TargetId id) {
    DefaultPlanner& planner = planner_;
    if (planner.queue_.room() == 0 && planner.sink_ != nullptr && !planner.keeps_all_) planner.emit_front();
    return planner.begin_segment(planner.queue_.next(), id);
}

void DefaultPlanner::Output::finish() {
    const Segment& segment = planner_.queue_.next();
    planner_.end_s_ = segment.end_s();
    planner_.queue_.push();
    if (!segment.reaches_target) return;
    const rrs::TargetId id = segment.target_id;
    planner_.held_.reached(id, [&](rrs::TargetId passed) { planner_.events_.join(passed, id); });
}

void DefaultPlanner::flush() {
    if (stopped_) go_on();
    come_to_rest();
    while (!queue_.empty()) emit_front();
}

// The segment leaves the queue before the sink sees it: it stays whole in its slot until a target takes the
// slot, and leaves only once even if the sink throws.
void DefaultPlanner::emit_front() {
    const Segment& segment = queue_.front();
    events_.leave(queue_);
    queue_.pop();
    step_s_ = std::max(step_s_, segment.end_s());
    if (sink_ != nullptr) sink_->take(segment);
}

Status DefaultPlanner::GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) {
    if (!initialized_) return not_initialized();
    if (!has_position_)
        return refuse(Status::RRS_NO_INITIAL_POSITION, "There is no position to step from yet.");
    const double from_s = step_s_;
    const double known_s = events_.known_until_s(held_, queue_, end_s_).value_or(end_s_);
    if (from_s + programmed_.interpolation_s > known_s) come_to_rest();
    Status status = queue_.empty() ? Status::RRS_NEED_MORE_DATA : Status::RRS_SUCCESS;
    step_s_ = std::min(from_s + programmed_.interpolation_s, end_s_);
    events_.step(from_s, step_s_, queue_);
    joints = stopped_ ? stopped_->position : position_at_end();
    while (!queue_.empty() && queue_.front().end_s() <= step_s_) {
        step_target_ = queue_.front().target_id;
        if (queue_.front().reaches_target) status = Status::RRS_TARGET_REACHED;
        emit_front();
    }
    if (!queue_.empty()) {
        const Segment& front = queue_.front();
        joints = front.position_at(step_s_ - front.start_s);
        if (step_s_ > front.start_s) step_target_ = front.target_id;
    }
    pose = frames_of_step(from_s).target_of(setup_.kinematics->forward(joints));
    elapsed_s = step_s_ - from_s;
    return status;
}

rrs::JointPos DefaultPlanner::standing() const {
    return holds_back() ? model_->standing_at(position_) : position_;
}

Status DefaultPlanner::GetTargetOfLastStep(rrs::TargetId& id) {
    if (!initialized_) return not_initialized();
    id = step_target_;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::tell(PlanError error) {
    error_ = std::move(error);
    return error_.status;
}

Status DefaultPlanner::refuse(Status status, std::string message) {
    return tell({.status = status, .message = std::move(message)});
}

Status DefaultPlanner::not_initialized() {
    return refuse(Status::RRS_NOT_INITIALIZED, "The planner is not initialized; call Initialize first.");
}

Status DefaultPlanner::not_supported(std::string_view service) {
    return refuse(Status::RRS_SERVICE_NOT_SUPPORTED,
                  fmt::format("The default planner does not offer the service {}.", service));
}

}  // namespace gsim::motion
