#include "runtime/motion/planner.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::Status;

namespace {

PlannerSetup valid(PlannerSetup setup) {
    if (auto trouble = setup.validate()) throw std::invalid_argument(*trouble);
    return setup;
}

}  // namespace

DefaultPlanner::DefaultPlanner(PlannerSetup setup, SegmentSink* sink)
    : setup_(valid(std::move(setup))),
      sink_(sink),
      axis_space_(AxisSpace::of(setup_)),
      queue_(setup_.queue_capacity),
      programmed_(setup_.joint_count()),
      position_(rrs::JointPos::Zero(setup_.joint_count())) {}

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
    programmed_ = Programmed(setup_.joint_count());
    position_.setZero();
    via_.reset();
    error_ = {};
    end_s_ = 0;
    step_s_ = 0;
    has_position_ = false;
}

void DefaultPlanner::flush() {
    while (!queue_.empty()) emit_front();
}

// The segment leaves the queue before the sink sees it: it stays whole in its slot until a target takes the
// slot, and leaves only once even if the sink throws.
void DefaultPlanner::emit_front() {
    const Segment& segment = queue_.front();
    queue_.pop();
    step_s_ = std::max(step_s_, segment.end_s());
    if (sink_ != nullptr) sink_->take(segment);
}

Status DefaultPlanner::GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) {
    if (!initialized_) return not_initialized();
    if (!has_position_)
        return refuse(Status::RRS_NO_INITIAL_POSITION, "There is no position to step from yet.");
    const double from_s = step_s_;
    Status status = queue_.empty() ? Status::RRS_NEED_MORE_DATA : Status::RRS_SUCCESS;
    step_s_ = std::min(from_s + programmed_.interpolation_s, end_s_);
    joints = position_;
    while (!queue_.empty() && queue_.front().end_s() <= step_s_) {
        emit_front();
        status = Status::RRS_TARGET_REACHED;
    }
    if (!queue_.empty()) joints = queue_.front().position_at(step_s_ - queue_.front().start_s);
    pose = setup_.kinematics->forward(joints);
    elapsed_s = step_s_ - from_s;
    return status;
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
