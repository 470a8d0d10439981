#include "runtime/rrs/shell.h"

namespace gsim::rrs {

Status Shell::Initialize() {
    return not_supported("Initialize");
}

Status Shell::Reset() {
    return not_supported("Reset");
}

Status Shell::Terminate() {
    return not_supported("Terminate");
}

Status Shell::GetMessage(std::string&) {
    return not_supported("GetMessage");
}

Status Shell::GetInverseKinematics(const CartPos&, const JointPos&, JointPos&) {
    return not_supported("GetInverseKinematics");
}

Status Shell::GetForwardKinematics(const JointPos&, CartPos&) {
    return not_supported("GetForwardKinematics");
}

Status Shell::GetCellFrame(std::string_view, CartPos&) {
    return not_supported("GetCellFrame");
}

Status Shell::ModifyCellFrame(std::string_view, const CartPos&) {
    return not_supported("ModifyCellFrame");
}

Status Shell::SelectWorkFrames(std::string_view, std::string_view) {
    return not_supported("SelectWorkFrames");
}

Status Shell::SelectTargetType(TargetType) {
    return not_supported("SelectTargetType");
}

Status Shell::SelectTrajectoryMode(int) {
    return not_supported("SelectTrajectoryMode");
}

Status Shell::SetInitialPosition(const CartPos&, const JointPos&, std::string_view) {
    return not_supported("SetInitialPosition");
}

Status Shell::SetNextTarget(TargetId, TargetParam, const CartPos&, const JointPos&, std::string_view,
                            double) {
    return not_supported("SetNextTarget");
}

Status Shell::SetNextNamedTarget(TargetId, TargetParam, const CartPos&, const JointPos&, std::string_view,
                                 double, std::string_view) {
    return not_supported("SetNextNamedTarget");
}

Status Shell::GetNextStep(JointPos&, CartPos&, double&) {
    return not_supported("GetNextStep");
}

Status Shell::SetInterpolationTime(double) {
    return not_supported("SetInterpolationTime");
}

Status Shell::StopMotion() {
    return not_supported("StopMotion");
}

Status Shell::ContinueMotion() {
    return not_supported("ContinueMotion");
}

Status Shell::CancelMotion() {
    return not_supported("CancelMotion");
}

Status Shell::SelectMotionType(MotionType) {
    return not_supported("SelectMotionType");
}

Status Shell::SelectOrientationInterpolationMode(int) {
    return not_supported("SelectOrientationInterpolationMode");
}

Status Shell::SelectDominantInterpolation(Dominance) {
    return not_supported("SelectDominantInterpolation");
}

Status Shell::SetJointSpeeds(std::span<const int>, std::span<const double>) {
    return not_supported("SetJointSpeeds");
}

Status Shell::SetJointAccelerations(std::span<const int>, std::span<const double>) {
    return not_supported("SetJointAccelerations");
}

Status Shell::SetJointJerks(std::span<const int>, std::span<const double>) {
    return not_supported("SetJointJerks");
}

Status Shell::SetCartesianPositionSpeed(double) {
    return not_supported("SetCartesianPositionSpeed");
}

Status Shell::SetCartesianOrientationSpeed(double) {
    return not_supported("SetCartesianOrientationSpeed");
}

Status Shell::SetCartesianPositionAcceleration(double) {
    return not_supported("SetCartesianPositionAcceleration");
}

Status Shell::SetCartesianOrientationAcceleration(double) {
    return not_supported("SetCartesianOrientationAcceleration");
}

Status Shell::SetOverrideSpeed(double) {
    return not_supported("SetOverrideSpeed");
}

Status Shell::SetOverrideAcceleration(double) {
    return not_supported("SetOverrideAcceleration");
}

Status Shell::SetMotionTime(double) {
    return not_supported("SetMotionTime");
}

Status Shell::SetRestParameter(double) {
    return not_supported("SetRestParameter");
}

Status Shell::SelectFlybyMode(bool) {
    return not_supported("SelectFlybyMode");
}

Status Shell::SelectFlybyCriteria(int) {
    return not_supported("SelectFlybyCriteria");
}

Status Shell::SetFlybyCriteriaParameter(int, int, double) {
    return not_supported("SetFlybyCriteriaParameter");
}

Status Shell::CancelFlybyCriteria(int) {
    return not_supported("CancelFlybyCriteria");
}

Status Shell::SelectPointAccuracy(int) {
    return not_supported("SelectPointAccuracy");
}

Status Shell::SetPointAccuracyParameter(int, double) {
    return not_supported("SetPointAccuracyParameter");
}

Status Shell::DefineEvent(int, TargetId, double) {
    return not_supported("DefineEvent");
}

Status Shell::CancelEvent(int) {
    return not_supported("CancelEvent");
}

Status Shell::GetEvent(int, int&, double&) {
    return not_supported("GetEvent");
}

Status Shell::SelectTracking(int, bool) {
    return not_supported("SelectTracking");
}

Status Shell::SetConveyorPosition(int, double) {
    return not_supported("SetConveyorPosition");
}

Status Shell::DefineConveyor(int, const Eigen::Vector3d&, double) {
    return not_supported("DefineConveyor");
}

Status Shell::SetObjectInitialPosition(const CartPos&) {
    return not_supported("SetObjectInitialPosition");
}

Status Shell::SelectObject(std::string_view) {
    return not_supported("SelectObject");
}

Status Shell::SetObjectSpeed(double) {
    return not_supported("SetObjectSpeed");
}

Status Shell::SetObjectNextTarget(TargetId, const CartPos&) {
    return not_supported("SetObjectNextTarget");
}

Status Shell::GetNextObjectStep(CartPos&, double&) {
    return not_supported("GetNextObjectStep");
}

Status Shell::SetRapid(bool) {
    return not_supported("SetRapid");
}

Status Shell::SetPathMode(PathMode, double, double) {
    return not_supported("SetPathMode");
}

Status Shell::SetNextArcTarget(TargetId, const Eigen::Vector3d&, const Eigen::Vector3d&, double,
                               const CartPos&, const JointPos&) {
    return not_supported("SetNextArcTarget");
}

Status Shell::SetRampMode(RampMode) {
    return not_supported("SetRampMode");
}

Status Shell::SetJointRampLimits(RampLimit, std::span<const int>, std::span<const double>) {
    return not_supported("SetJointRampLimits");
}

Status Shell::DefinePathEvent(int, TargetId, double) {
    return not_supported("DefinePathEvent");
}

Status Shell::SetNextRest(TargetId, double) {
    return not_supported("SetNextRest");
}

Status Shell::GetTargetOfLastStep(TargetId&) {
    return not_supported("GetTargetOfLastStep");
}

Status Shell::SetTipControl(bool, const Eigen::Vector3d&) {
    return not_supported("SetTipControl");
}

Status Shell::ComeToRest(RestReason) {
    return not_supported("ComeToRest");
}

Status Shell::not_supported(std::string_view) {
    return Status::RRS_SERVICE_NOT_SUPPORTED;
}

}  // namespace gsim::rrs
