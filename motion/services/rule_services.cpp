#include "motion/services/rule_services.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "motion/path/master_path.h"
#include "motion/path/orientation_path.h"

namespace gsim::motion {

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
void RuleServices::change_machine(const Change& change) {
    PlannerSetup changed =
        selections_.move_parameters.machine ? *selections_.move_parameters.machine : machine_.original();
    change(changed);
    selections_.move_parameters.machine = std::make_shared<const PlannerSetup>(std::move(changed));
    machine_.use(selections_.move_parameters);
}

PlanResult RuleServices::check_criterion(int criterion) const {
    if (criterion < kVelocityStep || criterion > kBlendTolerance) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("Invalid fly-by criterion {}; 1 is the step of the joint speeds, "
                                           "2 the junction deviation, 3 the corner tolerance.",
                                           criterion));
    }
    const rrs::ControllerRules& controller = machine_.original().controller;
    const bool blends =
        controller.capabilities().blends_at_tolerance || is_blend(controller.corners.continuous);
    const bool has = criterion == kBlendTolerance ? blends : controller.capabilities().applies_corner_rules;
    if (has) return {};
    return make_plan_error(
        Status::RRS_MODE_NOT_SUPPORTED,
        fmt::format("This controller does not support the criterion {} for corners.", criterion));
}

PlanResult RuleServices::select_flyby_criteria(int criterion) {
    if (PlanResult checked = check_criterion(criterion); !checked) return checked;
    selections_.flyby_criterion = criterion;
    if (criterion == kBlendTolerance) {
        selections_.move_parameters.tolerance_mm = selections_.blend_tolerance_mm;
    }
    set_corner_rule(criterion == kBlendTolerance ? machine_.original().controller.corners.continuous
                                                 : corner_rule(criterion));
    return {};
}

PlanResult RuleServices::check_criterion_value(int criterion, int joint, double value) const {
    const bool is_of_joint = criterion == kVelocityStep;
    if (joint < -1 || joint >= (is_of_joint ? machine_.setup().joint_count() : 0)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The fly-by criterion {} has no value for joint {}.", criterion, joint));
    }
    if (!(value >= 0 && value < kUnlimited) || (is_of_joint && value == 0)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("{} is not a valid value for the fly-by criterion {}.", value, criterion));
    }
    return {};
}

PlanResult RuleServices::set_flyby_criteria_parameter(int criterion, int joint, double value) {
    if (PlanResult checked = check_criterion(criterion); !checked) return checked;
    if (PlanResult checked = check_criterion_value(criterion, joint, value); !checked) return checked;
    if (criterion == kJunctionDeviation)
        change_machine([&](PlannerSetup& setup) { setup.controller.corners.junction_deviation_mm = value; });
    if (criterion == kBlendTolerance) {
        selections_.blend_tolerance_mm = value;
        if (selections_.flyby_criterion == criterion) selections_.move_parameters.tolerance_mm = value;
    }
    if (criterion != kVelocityStep) return {};
    change_machine([&](PlannerSetup& setup) {
        for (int i = 0; i < setup.joint_count(); ++i) {
            if (joint == -1 || joint == i) setup.joints[static_cast<std::size_t>(i)].max_speed_step = value;
        }
    });
    return {};
}

void RuleServices::set_corner_rule(rrs::CornerRule rule) {
    change_machine([&](PlannerSetup& setup) { setup.controller.corners.continuous = rule; });
}

PlanResult RuleServices::cancel_flyby_criteria(int criterion) {
    if (PlanResult checked = check_criterion(criterion); !checked) return checked;
    if (selections_.flyby_criterion != criterion) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The fly-by criterion {} is not active.", criterion));
    }
    selections_.flyby_criterion = 0;
    if (criterion == kBlendTolerance) selections_.move_parameters.tolerance_mm = 0;
    set_corner_rule(machine_.original().controller.corners.continuous);
    return {};
}

PlanResult RuleServices::check_accuracy(int accuracy_type) const {
    if (accuracy_type != kNoSettling && accuracy_type != kSettling) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("Invalid point accuracy {}; 0 is an exact stop, 1 an exact stop "
                                           "that waits until the axes are in position.",
                                           accuracy_type));
    }
    if (accuracy_type == kNoSettling || machine_.setup().controller.capabilities().waits_in_position)
        return {};
    return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                           "This controller does not wait at exact stops; a dwell does (SetRestParameter).");
}

PlanResult RuleServices::select_point_accuracy(int accuracy_type) {
    if (PlanResult checked = check_accuracy(accuracy_type); !checked) return checked;
    selections_.settles = accuracy_type == kSettling;
    const bool waits = accuracy_type == kSettling;
    const rrs::ControllerRules& rules = machine_.original().controller;
    change_machine([&](PlannerSetup& setup) {
        setup.controller.position_loop.settle_s =
            waits ? selections_.settle_s.value_or(rules.position_loop.settle_s) : 0;
        setup.controller.position_loop.in_position_mm =
            waits ? rules.position_loop.in_position_mm : kUnlimited;
        setup.controller.position_loop.in_position_deg =
            waits ? rules.position_loop.in_position_deg : kUnlimited;
    });
    return {};
}

PlanResult RuleServices::set_point_accuracy_parameter(int accuracy_type, double value) {
    if (PlanResult checked = check_accuracy(accuracy_type); !checked) return checked;
    if (accuracy_type != kSettling || !(value >= 0 && value <= kMaxDuration_s)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("{} is not a valid value for the point accuracy {}; 1 needs a time from 0 to {} s.",
                        value, accuracy_type, kMaxDuration_s));
    }
    selections_.settle_s = value;
    if (selections_.settles)
        change_machine([&](PlannerSetup& setup) { setup.controller.position_loop.settle_s = value; });
    return {};
}

PlanResult RuleServices::select_orientation_interpolation_mode(int mode) {
    if (mode != 0 && mode != 1) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid orientation mode {}; 0 is by the joint angles, 1 along the great circle.",
                        mode));
    }
    if (mode == 1) {
        if (auto obstacle = find_great_circle_error(machine_.setup()))
            return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED, *std::move(obstacle));
    }
    change_machine([&](PlannerSetup& setup) {
        setup.controller.coordination.orientation =
            mode == 1 ? rrs::OrientationRule::great_circle : rrs::OrientationRule::joints;
    });
    return {};
}

}  // namespace gsim::motion
