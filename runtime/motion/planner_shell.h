#pragma once

#include <Eigen/Core>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/motion/cell_frames.h"
#include "runtime/motion/machine_frames.h"
#include "runtime/motion/object_motion.h"
#include "runtime/motion/plan_error.h"
#include "runtime/motion/planner.h"
#include "runtime/motion/selections.h"
#include "runtime/rrs/shell.h"

namespace gsim::motion {

/// Planner behind the services: what a client selects and sets is kept here, in Selections, until it puts a
/// target, which becomes a Move with all of it. `configuration` and `param_value` of targets are not looked
/// at.
///
/// Services of time: StopMotion brakes from the instant at which GetNextStep stands; GetNextStep then goes on
/// to the stop. Until ContinueMotion or CancelMotion targets are refused (RRS_QUEUE_FULL). Events come true
/// in the steps of GetNextStep. The dwell of SetRestParameter is a segment of its own with its target's id. A
/// via point has no segment.
class PlannerShell : public rrs::Shell {
  public:
    /// `planner` must outlive the shell. Moves that others put to it go between this one's.
    explicit PlannerShell(Planner& planner);
    PlannerShell(const PlannerShell&) = delete;
    PlannerShell& operator=(const PlannerShell&) = delete;

    /// The robot stands in this cell, which must outlive the planner, on whose clock the run's time is.
    void set_cell(CellFrames& cell) { cell_ = &cell; }
    /// What the targets that follow obey of the operator's overrides, which no service says.
    void set_obeyed(const ObeyedOverrides& obeyed) { selections_.terms.obeyed = obeyed; }
    const Selections& selections() const { return selections_; }
    /// The last answer other than plain success, with its numbers; GetMessage gives its sentence.
    const PlanError& last_error() const { return error_; }

    rrs::Status Initialize() override;
    rrs::Status Reset() override;
    rrs::Status Terminate() override;
    rrs::Status GetMessage(std::string& message) override;

    rrs::Status GetInverseKinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                     rrs::JointPos& joints) override;
    rrs::Status GetForwardKinematics(const rrs::JointPos& joints, rrs::CartPos& pose) override;

    rrs::Status GetCellFrame(std::string_view frame_name, rrs::CartPos& frame) override;
    rrs::Status ModifyCellFrame(std::string_view frame_name, const rrs::CartPos& frame) override;
    rrs::Status SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) override;

    rrs::Status SelectTargetType(rrs::TargetType type) override;
    rrs::Status SetInitialPosition(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                   std::string_view configuration) override;
    rrs::Status SetNextTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                              const rrs::JointPos& joints, std::string_view configuration,
                              double param_value) override;
    rrs::Status SetNextNamedTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                                   const rrs::JointPos& joints, std::string_view configuration,
                                   double param_value, std::string_view target_name) override;
    rrs::Status SetNextArcTarget(rrs::TargetId id, const Eigen::Vector3d& center_mm,
                                 const Eigen::Vector3d& axis, double sweep_rad, const rrs::CartPos& cartesian,
                                 const rrs::JointPos& joints) override;
    rrs::Status SetNextRest(rrs::TargetId id, double rest_s) override;
    rrs::Status ComeToRest(rrs::RestReason reason) override;

    rrs::Status GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) override;
    rrs::Status GetTargetOfLastStep(rrs::TargetId& id) override;
    rrs::Status SetInterpolationTime(double interpolation_s) override;
    rrs::Status StopMotion() override;
    rrs::Status ContinueMotion() override;
    rrs::Status CancelMotion() override;

    rrs::Status SelectMotionType(rrs::MotionType type) override;
    rrs::Status SelectOrientationInterpolationMode(int mode) override;
    rrs::Status SelectDominantInterpolation(rrs::Dominance dominance) override;
    rrs::Status SelectFlybyMode(bool on) override;
    rrs::Status SetPathMode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) override;
    rrs::Status SetRapid(bool on) override;
    rrs::Status SetTipControl(bool on, const Eigen::Vector3d& tip_mm) override;
    rrs::Status SelectFlybyCriteria(int criterion) override;
    rrs::Status SetFlybyCriteriaParameter(int criterion, int joint, double value) override;
    rrs::Status CancelFlybyCriteria(int criterion) override;
    rrs::Status SelectPointAccuracy(int accuracy_type) override;
    rrs::Status SetPointAccuracyParameter(int accuracy_type, double value) override;

    rrs::Status SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) override;
    rrs::Status SetJointAccelerations(std::span<const int> joints,
                                      std::span<const double> accelerations) override;
    rrs::Status SetJointJerks(std::span<const int> joints, std::span<const double> jerks) override;
    rrs::Status SetRampMode(rrs::RampMode mode) override;
    rrs::Status SetJointRampLimits(rrs::RampLimit limit, std::span<const int> joints,
                                   std::span<const double> values) override;
    rrs::Status SetCartesianPositionSpeed(double speed_mm_s) override;
    rrs::Status SetCartesianOrientationSpeed(double speed_rad_s) override;
    rrs::Status SetCartesianPositionAcceleration(double acceleration_mm_s2) override;
    rrs::Status SetCartesianOrientationAcceleration(double acceleration_rad_s2) override;
    rrs::Status SetOverrideSpeed(double percent) override;
    rrs::Status SetOverrideAcceleration(double percent) override;
    rrs::Status SetMotionTime(double motion_s) override;
    rrs::Status SetRestParameter(double rest_s) override;

    rrs::Status DefineEvent(int event_id, rrs::TargetId target, double offset_s) override;
    rrs::Status DefinePathEvent(int event_id, rrs::TargetId target, double offset_mm) override;
    rrs::Status CancelEvent(int event_id) override;
    rrs::Status GetEvent(int number, int& event_id, double& time_s) override;

    rrs::Status DefineConveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) override;
    rrs::Status SelectTracking(int conveyor, bool on) override;
    rrs::Status SetConveyorPosition(int conveyor, double position_mm) override;
    rrs::Status SelectObject(std::string_view frame_name) override;
    rrs::Status SetObjectInitialPosition(const rrs::CartPos& pose) override;
    rrs::Status SetObjectSpeed(double speed_mm_s) override;
    rrs::Status SetObjectNextTarget(rrs::TargetId id, const rrs::CartPos& pose) override;
    rrs::Status GetNextObjectStep(rrs::CartPos& pose, double& elapsed_s) override;

  protected:
    rrs::Status not_supported(std::string_view service) override;

  private:
    rrs::Status tell(PlanError error);
    rrs::Status tell(Planned planned);
    rrs::Status refuse(rrs::Status status, std::string message);
    rrs::Status not_initialized();
    rrs::Status set_positive(double& value, double wanted, std::string_view what);
    rrs::Status set_percent(double& factor, double percent, std::string_view what);
    rrs::Status set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                 std::span<const double> wanted, std::string_view what);
    rrs::Status set_joint_terms(rrs::JointPos JointTerms::*values, std::span<const int> joints,
                                std::span<const double> wanted, std::string_view what);
    ProgrammedRamps ramps() const;
    void set_ramps(const ProgrammedRamps& ramps);
    rrs::Status check_criterion(int criterion);
    rrs::Status check_accuracy(int accuracy_type);
    template <typename Change>
    void change_machine(const Change& change);
    void set_corner_rule(rrs::CornerRule rule);
    rrs::Status define_event(int event_id, rrs::TargetId target, EventOffset offset);

    void start_over();
    Goal goal(const rrs::CartPos& cartesian, const rrs::JointPos& joints) const;
    Move move_to(rrs::TargetId id, rrs::MotionType type, Goal goal) const;
    rrs::Status put(const Move& move);
    rrs::Status keep_via(const Goal& goal);

    void keep_frames();
    Planned select_frames();
    const WorkFrames& frames_of_step(double from_s);
    void lead_object(const rrs::CartPos& pose, double duration_s);

    Planner& planner_;
    Selections selections_;
    std::optional<rrs::JointPos> via_;
    CellFrames* cell_ = nullptr;
    /// Frames in which the poses of what was queued are told, until frames were moved.
    struct FramesUntil {
        double until_s;
        WorkFrames frames;
    };
    std::deque<FramesUntil> frames_before_;
    double machine_moved_s_ = 0;  ///< When one of MachineFrames was changed last.
    ObjectMotion object_;
    std::optional<std::string> object_frame_;  ///< Of the cell; that the object is.
    double object_free_s_ = 0;                 ///< When it is at its last target.
    PlanError error_;
    bool initialized_ = false;
};

}  // namespace gsim::motion
