// Groups of axes: coordinated with moves to poses, or independent.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

namespace {

constexpr double kArrivalTolerance = 1e-9;  // mm or deg

bool contains(const std::vector<std::size_t>& axes, std::size_t axis) {
    return std::find(axes.begin(), axes.end(), axis) != axes.end();
}

}  // namespace

std::vector<motion::GroupJoint> Simulator::coordinated_joints(const std::vector<GroupTarget>& groups) const {
    std::vector<motion::GroupJoint> moved_by_group;
    for (const GroupTarget& target : groups) {
        const auto has_axis = [&](const machine::AxisGroup& group) {
            return contains(group.axes, target.axis);
        };
        const auto group = std::find_if(machine_.groups.begin(), machine_.groups.end(), has_axis);
        const auto index = static_cast<std::size_t>(group - machine_.groups.begin());
        moved_by_group.push_back({static_cast<int>(target.axis),
                                  machine::joint_value(machine_.axes[target.axis], target.value),
                                  group_motions_[index] == machine::GroupMotion::coordinated});
    }
    return moved_by_group;
}

bool Simulator::move_group(std::size_t group, const std::vector<GroupTarget>& targets,
                           const SourceLocation& location) {
    if (!wait_for_groups(location)) return false;
    rrs::JointPos joints = motion_->position();
    std::string ways;
    for (const GroupTarget& target : targets) {
        const machine::Axis& axis = machine_.axes[target.axis];
        joints[static_cast<Eigen::Index>(target.axis)] = machine::joint_value(axis, target.value);
        ways += fmt::format(" {}{:.10g}", axis.letter, target.value);
    }
    const motion::OvertravelPermit pass(begin_move());
    if (const auto in_range = check_target(joints); !in_range)
        return report_plan_error(in_range.error(), location);
    if (const auto enqueue = motion_->enqueue_independent(joints); !enqueue)
        return report_plan_error(enqueue.error(), location);
    add_violations(location);
    position_ = position_at(motion_->position());
    for (const GroupTarget& target : targets) independent_axes_.push_back(target.axis);
    last_location_ = location;
    if (observer_ != nullptr)
        observer_->on_unrecordable_motion("a group of axes goes by itself, beside other moves");
    events_.add(motion_->time_s(),
                {.location = location,
                 .kind = "group",
                 .detail = fmt::format("{} to{}, {:.9g} s", machine_.groups[group].name, ways,
                                       motion_->independent_end_s() - motion_->time_s())});
    return true;
}

bool Simulator::wait_for_groups(const SourceLocation& location) {
    if (independent_axes_.empty()) return true;
    const double remaining_s = motion_->independent_end_s() - time_s();
    independent_axes_.clear();
    return remaining_s <= 0 || dwell(remaining_s, location);
}

bool Simulator::wait_if_coordinated(const AxisVector& target, const SourceLocation& location) {
    const bool moved_by_group =
        std::any_of(independent_axes_.begin(), independent_axes_.end(), [&](std::size_t axis) {
            const auto index = static_cast<Eigen::Index>(axis);
            return std::abs(target[index] - position_[index]) > kArrivalTolerance;
        });
    return !moved_by_group || wait_for_groups(location);
}

/// An inverse solution that holds no joints may move any axis.
bool Simulator::wait_if_coordinated(const PoseMove& move) {
    if (independent_axes_.empty()) return true;
    const bool moved_by_group =
        setup_.kinematics->fixed_joints().empty() ||
        std::any_of(move.groups.begin(), move.groups.end(),
                    [&](const GroupTarget& target) { return contains(independent_axes_, target.axis); });
    return !moved_by_group || wait_for_groups(move.location);
}

}  // namespace gsim::simulation
