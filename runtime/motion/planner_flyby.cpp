// The services of DefaultPlanner for corners, exact stops and orientation.

#include <fmt/format.h>

#include "runtime/motion/lead_path.h"
#include "runtime/motion/orientation_path.h"
#include "runtime/motion/planner.h"

namespace gsim::motion {

using rrs::PlannerKind;
using rrs::Status;

namespace {

enum Criterion { kVelocityStep = 1, kJunctionDeviation = 2, kBlendTolerance = 3 };
enum Accuracy { kNoWait = 0, kSettling = 1 };

rrs::CornerRule rule_of(int criterion) {
    return criterion == kVelocityStep ? rrs::CornerRule::velocity_step : rrs::CornerRule::junction_deviation;
}

}  // namespace

Status DefaultPlanner::check_criterion(int criterion) {
    if (!initialized_) return not_initialized();
    if (criterion < kVelocityStep || criterion > kBlendTolerance) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no fly-by criterion {}; 1 is the step of the joints' speeds, 2 the "
                        "junction deviation, 3 the tolerance of corners.",
                        criterion));
    }
    const rrs::ControllerRules& controller = machine_.controller;
    const bool blends = controller.planner == PlannerKind::linuxcnc || is_blend(controller.corner);
    const bool has = criterion == kBlendTolerance ? blends : controller.planner == PlannerKind::look_ahead;
    if (has) return Status::RRS_SUCCESS;
    return refuse(Status::RRS_MODE_NOT_SUPPORTED,
                  fmt::format("This controller does not pass corners by the criterion {}.", criterion));
}

Status DefaultPlanner::SelectFlybyCriteria(int criterion) {
    if (const Status status = check_criterion(criterion); status != Status::RRS_SUCCESS) return status;
    programmed_.flyby_criterion = criterion;
    if (criterion == kBlendTolerance) {
        programmed_.tolerance_mm = programmed_.blend_tolerance_mm;
        setup_.controller.corner = machine_.controller.corner;
    } else {
        setup_.controller.corner = rule_of(criterion);
    }
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetFlybyCriteriaParameter(int criterion, int joint, double value) {
    if (const Status status = check_criterion(criterion); status != Status::RRS_SUCCESS) return status;
    const bool of_joint = criterion == kVelocityStep;
    if (joint < -1 || joint >= (of_joint ? setup_.joint_count() : 0)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The fly-by criterion {} has no value for joint {}.", criterion, joint));
    }
    if (!(value >= 0 && value < kUnlimited) || (of_joint && value == 0)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("{} is no value for the fly-by criterion {}.", value, criterion));
    }
    if (criterion == kJunctionDeviation) setup_.controller.junction_deviation_mm = value;
    if (criterion == kBlendTolerance) {
        programmed_.blend_tolerance_mm = value;
        if (programmed_.flyby_criterion == criterion) programmed_.tolerance_mm = value;
    }
    if (!of_joint) return Status::RRS_SUCCESS;
    for (int i = 0; i < setup_.joint_count(); ++i) {
        if (joint == -1 || joint == i) setup_.joints[static_cast<std::size_t>(i)].max_speed_step = value;
    }
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::CancelFlybyCriteria(int criterion) {
    if (const Status status = check_criterion(criterion); status != Status::RRS_SUCCESS) return status;
    if (programmed_.flyby_criterion != criterion) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The fly-by criterion {} is not in force.", criterion));
    }
    programmed_.flyby_criterion = 0;
    if (criterion == kBlendTolerance) programmed_.tolerance_mm = 0;
    setup_.controller.corner = machine_.controller.corner;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::check_accuracy(int accuracy_type) {
    if (!initialized_) return not_initialized();
    if (accuracy_type != kNoWait && accuracy_type != kSettling) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("There is no point accuracy {}; 0 is an exact stop, 1 one that waits until "
                                  "the axes are in position.",
                                  accuracy_type));
    }
    if (accuracy_type == kNoWait || setup_.controller.planner == PlannerKind::look_ahead)
        return Status::RRS_SUCCESS;
    return refuse(Status::RRS_MODE_NOT_SUPPORTED,
                  "This controller does not wait at exact stops; a dwell does (SetRestParameter).");
}

Status DefaultPlanner::SelectPointAccuracy(int accuracy_type) {
    if (const Status status = check_accuracy(accuracy_type); status != Status::RRS_SUCCESS) return status;
    programmed_.settles = accuracy_type == kSettling;
    setup_.controller.settle_s =
        accuracy_type == kSettling ? programmed_.settle_s.value_or(machine_.controller.settle_s) : 0;
    const bool waits = accuracy_type == kSettling;
    setup_.controller.in_position_mm = waits ? machine_.controller.in_position_mm : kUnlimited;
    setup_.controller.in_position_deg = waits ? machine_.controller.in_position_deg : kUnlimited;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetPointAccuracyParameter(int accuracy_type, double value) {
    if (const Status status = check_accuracy(accuracy_type); status != Status::RRS_SUCCESS) return status;
    if (accuracy_type != kSettling || !(value >= 0 && value <= kLongest_s)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("{} is no value for the point accuracy {}; 1 has a time from 0 to {} s.",
                                  value, accuracy_type, kLongest_s));
    }
    programmed_.settle_s = value;
    if (programmed_.settles) setup_.controller.settle_s = value;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectOrientationInterpolationMode(int mode) {
    if (!initialized_) return not_initialized();
    if (mode != 0 && mode != 1) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("There is no mode {} of orientation; 0 is by the joint angles, 1 along the "
                                  "great circle.",
                                  mode));
    }
    if (mode == 1) {
        if (auto obstacle = no_great_circles(setup_))
            return refuse(Status::RRS_MODE_NOT_SUPPORTED, *std::move(obstacle));
    }
    setup_.controller.orientation =
        mode == 1 ? rrs::OrientationRule::great_circle : rrs::OrientationRule::joints;
    return Status::RRS_SUCCESS;
}

}  // namespace gsim::motion
