#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/rrs/rcs_host.h"
#include "runtime/rrs/shell.h"

namespace gsim::rrs {

/// The services of a controller module. Each answer is checked: a status that exists and that the service may
/// answer, numbers that are finite, as many joints as the machine has, a time that goes on and by no more
/// than a step. An answer that fails is a fault of the module: the service answers RRS_MODULE_FAULT,
/// GetMessage names module and service, and from then on no service calls the module.
class RcsShell : public Shell {
  public:
    RcsShell(RcsModule module, int joint_count) : module_(std::move(module)), joint_count_(joint_count) {}

    /// Of the library.
    const std::string& name() const { return module_.name(); }
    /// The fault that was found, as a sentence.
    const std::optional<std::string>& fault() const { return fault_; }
    double interpolation_s() const { return interpolation_s_; }

    Status Initialize() override;
    Status Reset() override;
    Status Terminate() override;
    Status GetMessage(std::string& message) override;

    Status GetInverseKinematics(const CartPos& pose, const JointPos& near, JointPos& joints) override;
    Status GetForwardKinematics(const JointPos& joints, CartPos& pose) override;
    Status GetCellFrame(std::string_view frame_name, CartPos& frame) override;
    Status ModifyCellFrame(std::string_view frame_name, const CartPos& frame) override;
    Status SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) override;

    Status SelectTargetType(TargetType type) override;
    Status SelectTrajectoryMode(int mode) override;
    Status SetInitialPosition(const CartPos& cartesian, const JointPos& joints,
                              std::string_view configuration) override;
    Status SetNextTarget(TargetId id, TargetParam param, const CartPos& cartesian, const JointPos& joints,
                         std::string_view configuration, double param_value) override;
    Status SetNextNamedTarget(TargetId id, TargetParam param, const CartPos& cartesian,
                              const JointPos& joints, std::string_view configuration, double param_value,
                              std::string_view target_name) override;

    Status GetNextStep(JointPos& joints, CartPos& pose, double& elapsed_s) override;
    Status SetInterpolationTime(double interpolation_s) override;
    Status StopMotion() override;
    Status ContinueMotion() override;
    Status CancelMotion() override;

    Status SelectMotionType(MotionType type) override;
    Status SelectOrientationInterpolationMode(int mode) override;
    Status SelectDominantInterpolation(Dominance dominance) override;

    Status SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) override;
    Status SetJointAccelerations(std::span<const int> joints, std::span<const double> accelerations) override;
    Status SetJointJerks(std::span<const int> joints, std::span<const double> jerks) override;
    Status SetCartesianPositionSpeed(double speed_mm_s) override;
    Status SetCartesianOrientationSpeed(double speed_rad_s) override;
    Status SetCartesianPositionAcceleration(double acceleration_mm_s2) override;
    Status SetCartesianOrientationAcceleration(double acceleration_rad_s2) override;
    Status SetOverrideSpeed(double percent) override;
    Status SetOverrideAcceleration(double percent) override;
    Status SetMotionTime(double motion_s) override;
    Status SetRestParameter(double rest_s) override;

    Status SelectFlybyMode(bool on) override;
    Status SelectFlybyCriteria(int criterion) override;
    Status SetFlybyCriteriaParameter(int criterion, int joint, double value) override;
    Status CancelFlybyCriteria(int criterion) override;
    Status SelectPointAccuracy(int accuracy_type) override;
    Status SetPointAccuracyParameter(int accuracy_type, double value) override;

    Status DefineEvent(int event_id, TargetId target, double offset_s) override;
    Status CancelEvent(int event_id) override;
    Status GetEvent(int number, int& event_id, double& time_s) override;
    Status SelectTracking(int conveyor, bool on) override;
    Status SetConveyorPosition(int conveyor, double position_mm) override;
    Status SetObjectSpeed(double speed_mm_s) override;
    Status SetObjectNextTarget(TargetId id, const CartPos& pose) override;
    Status GetNextObjectStep(CartPos& pose, double& elapsed_s) override;

    Status SetRapid(bool on) override;
    Status SetNextArcTarget(TargetId id, const Eigen::Vector3d& center_mm, const Eigen::Vector3d& axis,
                            double sweep_rad, const CartPos& cartesian, const JointPos& joints) override;
    Status SetPathMode(PathMode mode, double tolerance_mm, double merge_tolerance_mm) override;
    Status SetRampMode(RampMode mode) override;
    Status SetJointRampLimits(RampLimit limit, std::span<const int> joints,
                              std::span<const double> values) override;
    Status DefinePathEvent(int event_id, TargetId target, double offset_mm) override;
    Status SetNextRest(TargetId id, double rest_s) override;
    Status GetTargetOfLastStep(TargetId& id) override;
    Status ComeToRest(RestReason reason) override;

  protected:
    /// From now on the module is not called any more; answers RRS_MODULE_FAULT. `what` continues a sentence
    /// that begins with the module's name: "answered SetRapid with 7, which is no status".
    Status blame(std::string_view what);
    /// The module is about to be called.
    virtual void calling() {}

  private:
    /// A service by its name, for messages.
    struct Service {
        gsim_rcs_opcode opcode;
        std::string_view name;
    };
    /// What a service may answer beside success and errors.
    enum class Extra { none, step, raised };

    Status ask(const Service& service, const void* input, void* output, Extra extra = Extra::none);
    Status ask_number(const Service& service, double value);
    Status ask_integer(const Service& service, int value);
    Status put_joint_values(const Service& service, std::span<const int> joints,
                            std::span<const double> values, gsim_rcs_joint_values& input);
    Status ask_joint_values(const Service& service, std::span<const int> joints,
                            std::span<const double> values);
    Status ask_target(const Service& service, gsim_rcs_target& target, std::string_view configuration,
                      std::string_view name);
    Status refuse(std::string message);
    Status started(Status status);
    Status checked(const Service& service, const gsim_rcs_pose& answer, CartPos& pose);
    Status checked(const Service& service, const gsim_rcs_joints& answer, double largest, JointPos& joints);
    Status checked_elapsed(const Service& service, double answer_s, double& elapsed_s);

    RcsModule module_;
    int joint_count_;
    double interpolation_s_ = kDefaultInterpolation_s;
    double clock_s_ = 0;
    std::optional<std::string> own_message_;  ///< Why the last answer was no success, where the host knows.
    std::optional<std::string> fault_;

    static constexpr double kDefaultInterpolation_s = 0.01;  // Shell::SetInterpolationTime
};

}  // namespace gsim::rrs
