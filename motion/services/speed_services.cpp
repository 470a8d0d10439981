#include "motion/services/speed_services.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kMaxPercent = 200;

PlanResult set_positive(double& value, double requested, std::string_view what) {
    PlanResult checked = check_positive(requested, what);
    if (checked) value = requested;
    return checked;
}

PlanResult set_percent(double& factor, double percent, std::string_view what) {
    if (!(percent > 0 && percent <= kMaxPercent)) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The {} override must be above 0 and at most {} percent, not {}.",
                                           what, kMaxPercent, percent));
    }
    factor = percent / 100;
    return {};
}

}  // namespace

PlanResult SpeedServices::set_joint_speeds(std::span<const int> joints, std::span<const double> speeds) {
    return set_joint_parameters(&JointParameters::speeds, joints, speeds, "speed");
}

PlanResult SpeedServices::set_joint_accelerations(std::span<const int> joints,
                                                  std::span<const double> accelerations) {
    return set_joint_parameters(&JointParameters::accelerations, joints, accelerations, "acceleration");
}

PlanResult SpeedServices::set_joint_jerks(std::span<const int> joints, std::span<const double> jerks) {
    return set_joint_parameters(&JointParameters::jerks, joints, jerks, "jerk");
}

PlanResult SpeedServices::set_ramp_mode(rrs::RampMode mode) {
    const int number = static_cast<int>(mode);
    if (number < 0 || number > 3) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid ramp mode {}; 0 is that of the machine, 1 linear, 2 S-curve, 3 infinite.",
                        number));
    }
    if (mode != rrs::RampMode::machine) {
        if (PlanResult checked = machine_.check_ramps(); !checked) return checked;
    }
    ProgrammedRamps changed = ramps();
    changed.mode = mode;
    set_ramps(changed);
    return {};
}

PlanResult SpeedServices::set_joint_ramp_limits(rrs::RampLimit limit, std::span<const int> joints,
                                                std::span<const double> values) {
    const int number = static_cast<int>(limit);
    if (number < 0 || number > 2) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid limit {}; 0 is acceleration, 1 deceleration, 2 jerk.", number));
    }
    if (PlanResult checked = machine_.check_ramps(); !checked) return checked;
    constexpr std::string_view kNames[] = {"acceleration", "deceleration", "jerk"};
    ProgrammedRamps changed = ramps();
    PlanResult set = set_joint_values(changed.of(limit), joints, values, kNames[number]);
    if (set) set_ramps(changed);
    return set;
}

ProgrammedRamps SpeedServices::ramps() const {
    return selections_.move_parameters.ramps ? *selections_.move_parameters.ramps
                                             : ProgrammedRamps(machine_.setup().joint_count());
}

void SpeedServices::set_ramps(const ProgrammedRamps& ramps) {
    selections_.move_parameters.ramps = std::make_shared<const ProgrammedRamps>(ramps);
    machine_.use(selections_.move_parameters);
}

PlanResult SpeedServices::set_cartesian_position_speed(double speed_mm_s) {
    return set_positive(selections_.move_parameters.position_speed_mm_s, speed_mm_s, "speed");
}

PlanResult SpeedServices::set_cartesian_orientation_speed(double speed_rad_s) {
    return set_positive(selections_.move_parameters.orientation_speed_rad_s, speed_rad_s,
                        "orientation speed");
}

PlanResult SpeedServices::set_cartesian_position_acceleration(double acceleration_mm_s2) {
    return set_positive(selections_.move_parameters.position_acceleration_mm_s2, acceleration_mm_s2,
                        "acceleration");
}

PlanResult SpeedServices::set_cartesian_orientation_acceleration(double acceleration_rad_s2) {
    return set_positive(selections_.move_parameters.orientation_acceleration_rad_s2, acceleration_rad_s2,
                        "orientation acceleration");
}

PlanResult SpeedServices::set_override_speed(double percent) {
    return set_percent(selections_.move_parameters.speed_override, percent, "speed");
}

PlanResult SpeedServices::set_override_acceleration(double percent) {
    return set_percent(selections_.move_parameters.acceleration_override, percent, "acceleration");
}

PlanResult SpeedServices::set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                           std::span<const double> requested, std::string_view what) const {
    const PlannerSetup& setup = machine_.setup();
    const std::size_t count = joints.empty() ? setup.joints.size() : joints.size();
    if (requested.size() != count) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("{} values were given for the {} of {} joints.", requested.size(), what, count));
    }
    rrs::JointPos changed = values;
    for (std::size_t i = 0; i < count; ++i) {
        const int joint = joints.empty() ? static_cast<int>(i) : joints[i];
        if (joint < 0 || joint >= setup.joint_count()) {
            return make_plan_error(
                Status::RRS_INVALID_PARAMETER,
                fmt::format("Joint {} does not exist; joints are 0 to {}.", joint, setup.joint_count() - 1));
        }
        if (!(requested[i] > 0)) {
            return make_plan_error(
                Status::RRS_INVALID_PARAMETER,
                fmt::format("The {} of joint {} must be greater than 0, not {}.", what, joint, requested[i]));
        }
        changed[joint] = requested[i];
    }
    values = changed;
    return {};
}

PlanResult SpeedServices::set_joint_parameters(rrs::JointPos JointParameters::*values,
                                               std::span<const int> joints, std::span<const double> requested,
                                               std::string_view what) {
    JointParameters changed = selections_.move_parameters.joints
                                  ? *selections_.move_parameters.joints
                                  : JointParameters(machine_.setup().joint_count());
    PlanResult set = set_joint_values(changed.*values, joints, requested, what);
    if (set) selections_.move_parameters.joints = std::make_shared<const JointParameters>(std::move(changed));
    return set;
}

}  // namespace gsim::motion
