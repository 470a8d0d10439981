#include "motion/services/planner_shell.h"

#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::Status;

namespace {

Status status_of(const tl::expected<Status, PlanError>& served) {
    return *served;
}

Status status_of(const PlanResult&) {
    return Status::RRS_SUCCESS;
}

}  // namespace

PlannerShell::PlannerShell(Planner& planner)
    : planner_(planner),
      frames_(planner, selections_),
      kinematics_(planner.machine(), planner.targets(), selections_),
      targets_(planner, selections_),
      steps_(planner, selections_, frames_, targets_),
      events_(planner.events()),
      speeds_(planner.machine(), selections_),
      path_modes_(selections_, planner.buffered_moves().can_pass_targets()),
      rules_(planner.machine(), selections_),
      objects_(planner, frames_, selections_) {}

/// Calls the function of a service, which may return an error or a status, and keeps the error. Each service
/// needs a session.
template <typename Service>
Status PlannerShell::serve(const Service& service) {
    if (!initialized_) {
        return to_status({.status = Status::RRS_NOT_INITIALIZED,
                          .message = "The planner is not initialized; call Initialize first."});
    }
    if constexpr (std::is_void_v<decltype(service())>) {
        service();
        return Status::RRS_SUCCESS;
    } else if constexpr (std::is_same_v<decltype(service()), Status>) {
        return service();
    } else {
        auto served = service();
        return served ? status_of(served) : to_status(std::move(served.error()));
    }
}

Status PlannerShell::to_status(PlanError error) {
    error_ = std::move(error);
    return error_.status;
}

Status PlannerShell::not_supported(std::string_view service) {
    return to_status(
        {.status = Status::RRS_SERVICE_NOT_SUPPORTED,
         .message = fmt::format("The default planner does not support the service {}.", service)});
}

// The frames of the cell are selected once the selections have their defaults.
void PlannerShell::restart() {
    planner_.restart();
    selections_ = {};
    targets_.drop_via();
    frames_.restart();
    objects_.restart();
    error_ = {};
}

// Session

Status PlannerShell::Initialize() {
    restart();
    initialized_ = true;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::Reset() {
    return serve([&] { restart(); });
}

Status PlannerShell::Terminate() {
    return serve([&] {
        restart();
        initialized_ = false;
    });
}

Status PlannerShell::GetMessage(std::string& message) {
    message = error_.message;
    return Status::RRS_SUCCESS;
}

// Kinematics and frames

Status PlannerShell::GetInverseKinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                          rrs::JointPos& joints) {
    return serve([&] { return kinematics_.get_inverse_kinematics(pose, near, joints); });
}

Status PlannerShell::GetForwardKinematics(const rrs::JointPos& joints, rrs::CartPos& pose) {
    return serve([&] { return kinematics_.get_forward_kinematics(joints, pose); });
}

Status PlannerShell::GetCellFrame(std::string_view frame_name, rrs::CartPos& frame) {
    if (frames_.cell() == nullptr) return Shell::GetCellFrame(frame_name, frame);
    return serve([&] { return frames_.get_cell_frame(frame_name, frame); });
}

Status PlannerShell::ModifyCellFrame(std::string_view frame_name, const rrs::CartPos& frame) {
    if (frames_.cell() == nullptr) return Shell::ModifyCellFrame(frame_name, frame);
    return serve([&] { return frames_.modify_cell_frame(frame_name, frame); });
}

Status PlannerShell::SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) {
    if (frames_.cell() == nullptr) return Shell::SelectWorkFrames(tool_frame, object_frame);
    return serve([&] { return frames_.select_work_frames(tool_frame, object_frame); });
}

// Targets

Status PlannerShell::SelectTargetType(rrs::TargetType type) {
    return serve([&] { return targets_.select_target_type(type); });
}

Status PlannerShell::SelectMotionType(rrs::MotionType type) {
    return serve([&] { return targets_.select_motion_type(type); });
}

// This planner has only one.
Status PlannerShell::SelectTrajectoryMode(int mode) {
    return Shell::SelectTrajectoryMode(mode);
}

Status PlannerShell::SetTipControl(bool on, const Eigen::Vector3d& tcp_mm) {
    return serve([&] { return targets_.set_tcp_control(on, tcp_mm); });
}

Status PlannerShell::SetMotionTime(double motion_s) {
    return serve([&] { return targets_.set_motion_time(motion_s); });
}

Status PlannerShell::SetRestParameter(double dwell_s) {
    return serve([&] { return targets_.set_dwell(dwell_s); });
}

Status PlannerShell::SetInitialPosition(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                        std::string_view) {
    return serve([&] { return targets_.set_initial_position(cartesian, joints); });
}

Status PlannerShell::SetNextTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                                   const rrs::JointPos& joints, std::string_view, double param_value) {
    return serve([&] { return targets_.set_next_target(id, param, cartesian, joints, param_value); });
}

Status PlannerShell::SetNextNamedTarget(rrs::TargetId id, rrs::TargetParam param,
                                        const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                        std::string_view configuration, double param_value,
                                        std::string_view target_name) {
    const Status status = SetNextTarget(id, param, cartesian, joints, configuration, param_value);
    if (status != Status::RRS_SUCCESS)
        error_.message = fmt::format("Target {}: {}", target_name, error_.message);
    return status;
}

Status PlannerShell::SetNextArcTarget(rrs::TargetId id, const Eigen::Vector3d& center_mm,
                                      const Eigen::Vector3d& axis, double sweep_rad,
                                      const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    return serve([&] {
        return targets_.set_next_arc_target(id, Circle{center_mm, axis, sweep_rad}, cartesian, joints);
    });
}

Status PlannerShell::SetNextRest(rrs::TargetId id, double dwell_s) {
    return serve([&] { return planner_.dwells().enqueue(id, dwell_s); });
}

Status PlannerShell::ComeToRest(rrs::RestReason reason) {
    return serve([&] { return targets_.plan_to_standstill(reason); });
}

// Motion over time

Status PlannerShell::GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) {
    return serve([&] { return steps_.get_next_step(joints, pose, elapsed_s); });
}

Status PlannerShell::SetInterpolationTime(double interpolation_s) {
    return serve([&] { return steps_.set_interpolation_time(interpolation_s); });
}

Status PlannerShell::GetTargetOfLastStep(rrs::TargetId& id) {
    return serve([&] { id = planner_.timeline().target_of_last_step(); });
}

Status PlannerShell::GetCurrentTargetId(rrs::TargetId& id) {
    return serve([&] { id = planner_.current_target(); });
}

Status PlannerShell::StopMotion() {
    return serve([&] { return steps_.stop_motion(); });
}

Status PlannerShell::ContinueMotion() {
    return serve([&] { return steps_.continue_motion(); });
}

Status PlannerShell::CancelMotion() {
    return serve([&] { return steps_.cancel_motion(); });
}

// Speeds, accelerations and ramps

Status PlannerShell::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    return serve([&] { return speeds_.set_joint_speeds(joints, speeds); });
}

Status PlannerShell::SetJointAccelerations(std::span<const int> joints,
                                           std::span<const double> accelerations) {
    return serve([&] { return speeds_.set_joint_accelerations(joints, accelerations); });
}

Status PlannerShell::SetJointJerks(std::span<const int> joints, std::span<const double> jerks) {
    return serve([&] { return speeds_.set_joint_jerks(joints, jerks); });
}

Status PlannerShell::SetRampMode(rrs::RampMode mode) {
    return serve([&] { return speeds_.set_ramp_mode(mode); });
}

Status PlannerShell::SetJointRampLimits(rrs::RampLimit limit, std::span<const int> joints,
                                        std::span<const double> values) {
    return serve([&] { return speeds_.set_joint_ramp_limits(limit, joints, values); });
}

Status PlannerShell::SetCartesianPositionSpeed(double speed_mm_s) {
    return serve([&] { return speeds_.set_cartesian_position_speed(speed_mm_s); });
}

Status PlannerShell::SetCartesianOrientationSpeed(double speed_rad_s) {
    return serve([&] { return speeds_.set_cartesian_orientation_speed(speed_rad_s); });
}

Status PlannerShell::SetCartesianPositionAcceleration(double acceleration_mm_s2) {
    return serve([&] { return speeds_.set_cartesian_position_acceleration(acceleration_mm_s2); });
}

Status PlannerShell::SetCartesianOrientationAcceleration(double acceleration_rad_s2) {
    return serve([&] { return speeds_.set_cartesian_orientation_acceleration(acceleration_rad_s2); });
}

Status PlannerShell::SetOverrideSpeed(double percent) {
    return serve([&] { return speeds_.set_override_speed(percent); });
}

Status PlannerShell::SetOverrideAcceleration(double percent) {
    return serve([&] { return speeds_.set_override_acceleration(percent); });
}

// Passing by targets, accuracy and orientation

Status PlannerShell::SelectFlybyMode(bool on) {
    return serve([&] { return path_modes_.select_flyby_mode(on); });
}

Status PlannerShell::SetPathMode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
    return serve([&] { return path_modes_.set_path_mode(mode, tolerance_mm, merge_tolerance_mm); });
}

Status PlannerShell::SelectDominantInterpolation(rrs::Dominance dominance) {
    return serve([&] { return path_modes_.select_dominant_interpolation(dominance); });
}

Status PlannerShell::SetRapid(bool on) {
    return serve([&] { path_modes_.set_rapid(on); });
}

Status PlannerShell::SelectFlybyCriteria(int criterion) {
    return serve([&] { return rules_.select_flyby_criteria(criterion); });
}

Status PlannerShell::SetFlybyCriteriaParameter(int criterion, int joint, double value) {
    return serve([&] { return rules_.set_flyby_criteria_parameter(criterion, joint, value); });
}

Status PlannerShell::CancelFlybyCriteria(int criterion) {
    return serve([&] { return rules_.cancel_flyby_criteria(criterion); });
}

Status PlannerShell::SelectPointAccuracy(int accuracy_type) {
    return serve([&] { return rules_.select_point_accuracy(accuracy_type); });
}

Status PlannerShell::SetPointAccuracyParameter(int accuracy_type, double value) {
    return serve([&] { return rules_.set_point_accuracy_parameter(accuracy_type, value); });
}

Status PlannerShell::SelectOrientationInterpolationMode(int mode) {
    return serve([&] { return rules_.select_orientation_interpolation_mode(mode); });
}

// Events and conveyors

Status PlannerShell::DefineEvent(int event_id, rrs::TargetId target, double offset_s) {
    return serve([&] {
        return events_.define_event(event_id, target, {EventOffset::Measure::time_s, offset_s});
    });
}

Status PlannerShell::DefinePathEvent(int event_id, rrs::TargetId target, double offset_mm) {
    return serve([&] {
        return events_.define_event(event_id, target, {EventOffset::Measure::distance_mm, offset_mm});
    });
}

Status PlannerShell::CancelEvent(int event_id) {
    return serve([&] { return events_.cancel_event(event_id); });
}

Status PlannerShell::GetEvent(int number, int& event_id, double& time_s) {
    return serve([&] { return events_.get_event(number, event_id, time_s); });
}

Status PlannerShell::DefineConveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) {
    return serve([&] { return planner_.conveyors().define(conveyor, direction, speed_mm_s); });
}

Status PlannerShell::SetConveyorPosition(int conveyor, double position_mm) {
    return serve([&] { return planner_.conveyors().set_position(conveyor, position_mm); });
}

Status PlannerShell::SelectTracking(int conveyor, bool on) {
    return serve([&] { return planner_.conveyors().select_tracking(conveyor, on, frames_.base_rotation()); });
}

// Motion of an object of the cell

Status PlannerShell::SelectObject(std::string_view frame_name) {
    if (frames_.cell() == nullptr) return Shell::SelectObject(frame_name);
    return serve([&] { return objects_.select_object(frame_name); });
}

Status PlannerShell::SetObjectInitialPosition(const rrs::CartPos& pose) {
    return serve([&] { return objects_.set_object_initial_position(pose); });
}

Status PlannerShell::SetObjectSpeed(double speed_mm_s) {
    return serve([&] { return objects_.set_object_speed(speed_mm_s); });
}

Status PlannerShell::SetObjectNextTarget(rrs::TargetId, const rrs::CartPos& pose) {
    return serve([&] { return objects_.set_object_next_target(pose); });
}

Status PlannerShell::GetNextObjectStep(rrs::CartPos& pose, double& elapsed_s) {
    return serve([&] { return objects_.get_next_object_step(pose, elapsed_s); });
}

}  // namespace gsim::motion
