// Shared zones as processes see them: which process has one, and which waits for it.

#include <algorithm>

#include <fmt/format.h>

#include "runtime/script/processes/processes.h"

namespace gsim::script {

using text::DiagnosticKind;

using process::ProcessId;

int Processes::enter_zone(lua_State* state, std::size_t zone) {
    if (zones_.enter(schedule_, zone, running_)) {
        tell_holder(zone, now().time_s);
        return 0;
    }
    if (const std::vector<ProcessId> stuck = schedule_.stuck_from(running_); !stuck.empty()) {
        alarm(state, DiagnosticKind::process,
              fmt::format("dead-lock: {}", schedule_.waits(interpreter().simulator().files(), stuck)));
    }
    return yield(state, Yielded::in_wait);
}

void Processes::leave_zone(std::size_t zone) {
    zones_.leave(schedule_, zone);
    tell_holder(zone, now().time_s);
}

/// Returns a deadlock if another process waits for a zone that this ended process has kept. It would wait
/// indefinitely, regardless of the others.
std::optional<Processes::Outcome> Processes::stuck_behind(ProcessId id) {
    const std::optional<ProcessId> first = schedule_.waits_for_zone_of(id);
    if (!first) return std::nullopt;
    Control* control = strands_[*first]->control != nullptr ? strands_[*first]->control : controls_[0];
    const std::string waits = schedule_.waits(control->simulator().files(), schedule_.stuck_from(*first));
    return Outcome{.end = End::deadlock,
                   .message = "dead-lock: " + waits,
                   .control = control,
                   .place = schedule_.process(*first).place};
}

/// Notifies the monitor that checks for robots in zones of others.
void Processes::tell_holder(std::size_t zone, double time_s) {
    if (robots_watch_ == nullptr) return;
    const std::optional<ProcessId>& id = zones_.holder(zone);
    if (!id) return robots_watch_->give_zone(zone, time_s, std::nullopt);
    robots_watch_->give_zone(zone, time_s, simulation::RobotsWatch::Holder{*id, schedule_.process(*id).name});
}

/// Notifies the same monitor of the robot's owner.
void Processes::tell_owner(const Control* control) {
    if (robots_watch_ == nullptr) return;
    const auto found = std::find(controls_.begin(), controls_.end(), control);
    robots_watch_->give_robot(static_cast<std::size_t>(found - controls_.begin()), now().time_s, running_);
}

}  // namespace gsim::script
