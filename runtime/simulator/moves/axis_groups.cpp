#include "runtime/simulator/moves/axis_groups.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

constexpr double kArrivalTolerance = 1e-9;  // mm or deg

bool contains(const std::vector<std::size_t>& axes, std::size_t axis) {
    return std::find(axes.begin(), axes.end(), axis) != axes.end();
}

}  // namespace

AxisGroups::AxisGroups(const machine::Machine& machine, MachineMotion& motion, RunClock& clock,
                       ProgramPosition& position, TargetIds& ids, RunOutcome& outcome,
                       RangeViolations& ranges, DwellQueue& dwells, EventLog& events,
                       const ProgramNotifier& notifier)
    : machine_(machine),
      motion_(motion),
      clock_(clock),
      position_(position),
      ids_(ids),
      outcome_(outcome),
      ranges_(ranges),
      dwells_(dwells),
      events_(events),
      notifier_(notifier) {
    for (const machine::AxisGroup& group : machine.groups) motions_.push_back(group.motion);
}

std::vector<motion::GroupJoint> AxisGroups::joints(const std::vector<GroupTarget>& targets) const {
    std::vector<motion::GroupJoint> moved_by_group;
    for (const GroupTarget& target : targets) {
        const auto has_axis = [&](const machine::AxisGroup& group) {
            return contains(group.axes, target.axis);
        };
        const auto group = std::find_if(machine_.groups.begin(), machine_.groups.end(), has_axis);
        const auto index = static_cast<std::size_t>(group - machine_.groups.begin());
        moved_by_group.push_back({static_cast<int>(target.axis),
                                  machine::joint_value(machine_.axes[target.axis], target.value),
                                  motions_[index] == machine::GroupMotion::coordinated});
    }
    return moved_by_group;
}

bool AxisGroups::move(std::size_t group, const std::vector<GroupTarget>& targets,
                      const SourceLocation& location) {
    if (!wait(location)) return false;
    MotionSource& source = motion_.source();
    rrs::JointPos joints = source.position();
    std::string axis_texts;
    for (const GroupTarget& target : targets) {
        const machine::Axis& axis = machine_.axes[target.axis];
        joints[static_cast<Eigen::Index>(target.axis)] = machine::joint_value(axis, target.value);
        axis_texts += fmt::format(" {}{:.10g}", axis.letter, target.value);
    }
    const motion::OvertravelPermit pass(ranges_.begin_move());
    if (const auto in_range = ranges_.check_target(joints); !in_range)
        return outcome_.fail(in_range.error(), location);
    if (const auto enqueue = source.enqueue_independent(joints); !enqueue)
        return outcome_.fail(enqueue.error(), location);
    ranges_.add_last(location);
    position_.set_joints(source.position());
    for (const GroupTarget& target : targets) independent_axes_.push_back(target.axis);
    ids_.set_last_location(location);
    notifier_.notify_unrecordable("an axis group moves independently during other moves");
    events_.add(source.time_s(),
                {.location = location,
                 .kind = "group",
                 .detail = fmt::format("{} to{}, {:.9g} s", machine_.groups[group].name, axis_texts,
                                       source.independent_end_s() - source.time_s())});
    return true;
}

bool AxisGroups::wait(const SourceLocation& location) {
    if (independent_axes_.empty()) return true;
    const double remaining_s = motion_.source().independent_end_s() - clock_.time_s();
    independent_axes_.clear();
    return remaining_s <= 0 || dwells_.enqueue(remaining_s, location);
}

bool AxisGroups::wait_before(const AxisVector& target, const SourceLocation& location) {
    const bool moved_by_group =
        std::any_of(independent_axes_.begin(), independent_axes_.end(), [&](std::size_t axis) {
            const auto index = static_cast<Eigen::Index>(axis);
            return std::abs(target[index] - position_.axes()[index]) > kArrivalTolerance;
        });
    return !moved_by_group || wait(location);
}

/// An inverse solution that holds no joints may move any axis.
bool AxisGroups::wait_before(const PoseMove& move) {
    if (independent_axes_.empty()) return true;
    const bool moved_by_group =
        motion_.setup().kinematics->fixed_joints().empty() ||
        std::any_of(move.groups.begin(), move.groups.end(),
                    [&](const GroupTarget& target) { return contains(independent_axes_, target.axis); });
    return !moved_by_group || wait(move.location);
}

}  // namespace gsim::simulation
