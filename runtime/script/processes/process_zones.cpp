// Shared zones as processes see them: which process has one, and which waits for it.

#include <algorithm>

#include <fmt/format.h>

#include "runtime/script/processes/processes.h"

namespace gsim::script {

using text::DiagnosticKind;

using process::ProcessId;

int Processes::enter_zone(lua_State* state, std::size_t zone) {
    if (zones_.enter(schedule_, zone, running_)) {
        notify_zone_holder(zone, now().time_s);
        return 0;
    }
    if (const std::vector<ProcessId> deadlocked = schedule_.deadlocked_from(running_); !deadlocked.empty()) {
        alarm(state, DiagnosticKind::process,
              fmt::format("dead-lock: {}", schedule_.waits(interpreter().simulator().files(), deadlocked)));
    }
    return yield(state, YieldReason::in_wait);
}

void Processes::leave_zone(std::size_t zone) {
    zones_.leave(schedule_, zone);
    notify_zone_holder(zone, now().time_s);
}

/// Returns a deadlock if another process waits for a zone that this ended process has kept. It would wait
/// indefinitely, regardless of the others.
std::optional<Processes::Outcome> Processes::find_deadlock(ProcessId id) {
    const std::optional<ProcessId> first = schedule_.find_zone_waiter(id);
    if (!first) return std::nullopt;
    RobotController* controller =
        lua_processes_[*first]->controller != nullptr ? lua_processes_[*first]->controller : controllers_[0];
    const std::string waits =
        schedule_.waits(controller->simulator().files(), schedule_.deadlocked_from(*first));
    return Outcome{.end = RunEnd::deadlock,
                   .message = "dead-lock: " + waits,
                   .controller = controller,
                   .location = schedule_.process(*first).location};
}

/// Notifies the monitor that checks for robots in zones of others.
void Processes::notify_zone_holder(std::size_t zone, double time_s) {
    if (multi_robot_monitor_ == nullptr) return;
    const std::optional<ProcessId>& id = zones_.holder(zone);
    if (!id) return multi_robot_monitor_->assign_zone(zone, time_s, std::nullopt);
    multi_robot_monitor_->assign_zone(
        zone, time_s, simulation::MultiRobotMonitor::ZoneHolder{*id, schedule_.process(*id).name});
}

/// Notifies the same monitor of the robot's owner.
void Processes::notify_robot_owner(const RobotController* controller) {
    if (multi_robot_monitor_ == nullptr) return;
    const auto found = std::find(controllers_.begin(), controllers_.end(), controller);
    multi_robot_monitor_->assign_robot(static_cast<std::size_t>(found - controllers_.begin()), now().time_s,
                                       running_);
}

}  // namespace gsim::script
