// Groups of axes: coordinated with moves to poses, or independent.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

namespace {

constexpr double kStands = 1e-9;  // mm or deg

bool holds(const std::vector<std::size_t>& axes, std::size_t axis) {
    return std::find(axes.begin(), axes.end(), axis) != axes.end();
}

}  // namespace

std::vector<motion::LedJoint> Simulator::led_joints(const std::vector<GroupTarget>& groups) const {
    std::vector<motion::LedJoint> led;
    for (const GroupTarget& target : groups) {
        const auto has_axis = [&](const machine::AxisGroup& group) { return holds(group.axes, target.axis); };
        const auto group = std::find_if(machine_.groups.begin(), machine_.groups.end(), has_axis);
        const auto index = static_cast<std::size_t>(group - machine_.groups.begin());
        led.push_back({static_cast<int>(target.axis),
                       machine::joint_value(machine_.axes[target.axis], target.value),
                       group_motions_[index] == machine::GroupMotion::coordinated});
    }
    return led;
}

bool Simulator::move_group(std::size_t group, const std::vector<GroupTarget>& targets, const Place& place) {
    if (!wait_for_groups(place)) return false;
    rrs::JointPos joints = motion_->position();
    std::string ways;
    for (const GroupTarget& target : targets) {
        const machine::Axis& axis = machine_.axes[target.axis];
        joints[static_cast<Eigen::Index>(target.axis)] = machine::joint_value(axis, target.value);
        ways += fmt::format(" {}{:.10g}", axis.letter, target.value);
    }
    const motion::RangePass pass(begin_move());
    if (const auto in_range = check_target(joints); !in_range) return refused(in_range.error(), place);
    if (const auto put = motion_->put_own(joints); !put) return refused(put.error(), place);
    add_violations(place);
    position_ = position_at(motion_->position());
    for (const GroupTarget& target : targets) own_axes_.push_back(target.axis);
    last_place_ = place;
    if (observer_ != nullptr) observer_->untold_motion("a group of axes goes by itself, beside other moves");
    events_.add(motion_->time_s(), {.place = place,
                                    .kind = "group",
                                    .detail = fmt::format("{} to{}, {:.9g} s", machine_.groups[group].name,
                                                          ways, motion_->own_end_s() - motion_->time_s())});
    return true;
}

bool Simulator::wait_for_groups(const Place& place) {
    if (own_axes_.empty()) return true;
    const double left_s = motion_->own_end_s() - time_s();
    own_axes_.clear();
    return left_s <= 0 || dwell(left_s, place);
}

bool Simulator::wait_if_led(const AxisVector& target, const Place& place) {
    const bool led = std::any_of(own_axes_.begin(), own_axes_.end(), [&](std::size_t axis) {
        const auto index = static_cast<Eigen::Index>(axis);
        return std::abs(target[index] - position_[index]) > kStands;
    });
    return !led || wait_for_groups(place);
}

/// An inverse solution that holds no joints may move any axis.
bool Simulator::wait_if_led(const PoseMove& move) {
    if (own_axes_.empty()) return true;
    const bool led = setup_.kinematics->held_joints().empty() ||
                     std::any_of(move.groups.begin(), move.groups.end(),
                                 [&](const GroupTarget& target) { return holds(own_axes_, target.axis); });
    return !led || wait_for_groups(move.place);
}

}  // namespace gsim::simulation
