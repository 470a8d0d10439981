// The services of PlannerShell for corners, exact stops and orientation.

#include <fmt/format.h>

#include "motion/path/master_path.h"
#include "motion/path/orientation_path.h"
#include "motion/services/planner_shell.h"

namespace gsim::motion {

using rrs::PlannerKind;
using rrs::Status;

namespace {

enum Criterion { kVelocityStep = 1, kJunctionDeviation = 2, kBlendTolerance = 3 };
enum Accuracy { kNoSettling = 0, kSettling = 1 };

rrs::CornerRule corner_rule(int criterion) {
    return criterion == kVelocityStep ? rrs::CornerRule::velocity_step : rrs::CornerRule::junction_deviation;
}

}  // namespace

/// Changes a rule of the machine for the targets that follow.
template <typename Change>
void PlannerShell::change_machine(const Change& change) {
    PlannerSetup changed =
        selections_.move_parameters.machine ? *selections_.move_parameters.machine : planner_.machine();
    change(changed);
    selections_.move_parameters.machine = std::make_shared<const PlannerSetup>(std::move(changed));
    planner_.use(selections_.move_parameters);
}

Status PlannerShell::check_criterion(int criterion) {
    if (!initialized_) return not_initialized();
    if (criterion < kVelocityStep || criterion > kBlendTolerance) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no fly-by criterion {}; 1 is the step of the joints' speeds, 2 the "
                        "junction deviation, 3 the tolerance of corners.",
                        criterion));
    }
    const rrs::ControllerRules& controller = planner_.machine().controller;
    const bool blends = controller.planner == PlannerKind::linuxcnc || is_blend(controller.corner);
    const bool has = criterion == kBlendTolerance ? blends : controller.planner == PlannerKind::look_ahead;
    if (has) return Status::RRS_SUCCESS;
    return reject(Status::RRS_MODE_NOT_SUPPORTED,
                  fmt::format("This controller does not pass corners by the criterion {}.", criterion));
}

Status PlannerShell::SelectFlybyCriteria(int criterion) {
    if (const Status status = check_criterion(criterion); status != Status::RRS_SUCCESS) return status;
    selections_.flyby_criterion = criterion;
    if (criterion == kBlendTolerance) {
        selections_.move_parameters.tolerance_mm = selections_.blend_tolerance_mm;
    }
    set_corner_rule(criterion == kBlendTolerance ? planner_.machine().controller.corner
                                                 : corner_rule(criterion));
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetFlybyCriteriaParameter(int criterion, int joint, double value) {
    if (const Status status = check_criterion(criterion); status != Status::RRS_SUCCESS) return status;
    const bool is_joint_parameter = criterion == kVelocityStep;
    if (joint < -1 || joint >= (is_joint_parameter ? planner_.setup().joint_count() : 0)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The fly-by criterion {} has no value for joint {}.", criterion, joint));
    }
    if (!(value >= 0 && value < kUnlimited) || (is_joint_parameter && value == 0)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("{} is no value for the fly-by criterion {}.", value, criterion));
    }
    if (criterion == kJunctionDeviation)
        change_machine([&](PlannerSetup& setup) { setup.controller.junction_deviation_mm = value; });
    if (criterion == kBlendTolerance) {
        selections_.blend_tolerance_mm = value;
        if (selections_.flyby_criterion == criterion) selections_.move_parameters.tolerance_mm = value;
    }
    if (!is_joint_parameter) return Status::RRS_SUCCESS;
    change_machine([&](PlannerSetup& setup) {
        for (int i = 0; i < setup.joint_count(); ++i) {
            if (joint == -1 || joint == i) setup.joints[static_cast<std::size_t>(i)].max_speed_step = value;
        }
    });
    return Status::RRS_SUCCESS;
}

void PlannerShell::set_corner_rule(rrs::CornerRule rule) {
    change_machine([&](PlannerSetup& setup) { setup.controller.corner = rule; });
}

Status PlannerShell::CancelFlybyCriteria(int criterion) {
    if (const Status status = check_criterion(criterion); status != Status::RRS_SUCCESS) return status;
    if (selections_.flyby_criterion != criterion) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The fly-by criterion {} is not in force.", criterion));
    }
    selections_.flyby_criterion = 0;
    if (criterion == kBlendTolerance) selections_.move_parameters.tolerance_mm = 0;
    set_corner_rule(planner_.machine().controller.corner);
    return Status::RRS_SUCCESS;
}

Status PlannerShell::check_accuracy(int accuracy_type) {
    if (!initialized_) return not_initialized();
    if (accuracy_type != kNoSettling && accuracy_type != kSettling) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("There is no point accuracy {}; 0 is an exact stop, 1 one that waits until "
                                  "the axes are in position.",
                                  accuracy_type));
    }
    if (accuracy_type == kNoSettling || planner_.setup().controller.planner == PlannerKind::look_ahead)
        return Status::RRS_SUCCESS;
    return reject(Status::RRS_MODE_NOT_SUPPORTED,
                  "This controller does not wait at exact stops; a dwell does (SetRestParameter).");
}

Status PlannerShell::SelectPointAccuracy(int accuracy_type) {
    if (const Status status = check_accuracy(accuracy_type); status != Status::RRS_SUCCESS) return status;
    selections_.settles = accuracy_type == kSettling;
    const bool waits = accuracy_type == kSettling;
    const rrs::ControllerRules& rules = planner_.machine().controller;
    change_machine([&](PlannerSetup& setup) {
        setup.controller.settle_s = waits ? selections_.settle_s.value_or(rules.settle_s) : 0;
        setup.controller.in_position_mm = waits ? rules.in_position_mm : kUnlimited;
        setup.controller.in_position_deg = waits ? rules.in_position_deg : kUnlimited;
    });
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetPointAccuracyParameter(int accuracy_type, double value) {
    if (const Status status = check_accuracy(accuracy_type); status != Status::RRS_SUCCESS) return status;
    if (accuracy_type != kSettling || !(value >= 0 && value <= kMaxDuration_s)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("{} is no value for the point accuracy {}; 1 has a time from 0 to {} s.",
                                  value, accuracy_type, kMaxDuration_s));
    }
    selections_.settle_s = value;
    if (selections_.settles) change_machine([&](PlannerSetup& setup) { setup.controller.settle_s = value; });
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SelectOrientationInterpolationMode(int mode) {
    if (!initialized_) return not_initialized();
    if (mode != 0 && mode != 1) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("There is no mode {} of orientation; 0 is by the joint angles, 1 along the "
                                  "great circle.",
                                  mode));
    }
    if (mode == 1) {
        if (auto obstacle = find_great_circle_error(planner_.setup()))
            return reject(Status::RRS_MODE_NOT_SUPPORTED, *std::move(obstacle));
    }
    change_machine([&](PlannerSetup& setup) {
        setup.controller.orientation =
            mode == 1 ? rrs::OrientationRule::great_circle : rrs::OrientationRule::joints;
    });
    return Status::RRS_SUCCESS;
}

}  // namespace gsim::motion
