// Shared zones as processes see them: who has one, and who waits for it.

#include <algorithm>

#include <fmt/format.h>

#include "runtime/script/processes.h"

namespace gsim::script {

using text::DiagnosticKind;

using process::ProcessId;

/// Processes that wait for each other's zones in a ring will never go on, whatever others do.
int Processes::enter_zone(lua_State* state, std::size_t zone) {
    if (zones_.enter(schedule_, zone, running_)) {
        tell_holder(zone, now().time_s);
        return 0;
    }
    if (const std::vector<ProcessId> ring = schedule_.ring_of(running_); !ring.empty()) {
        alarm(state, DiagnosticKind::process,
              fmt::format("dead-lock: {}", schedule_.waits(interpreter().simulator().files(), ring)));
    }
    return yield(state, Yielded::in_wait);
}

void Processes::leave_zone(std::size_t zone) {
    zones_.leave(schedule_, zone);
    tell_holder(zone, now().time_s);
}

/// For whoever looks for robots in zones of others.
void Processes::tell_holder(std::size_t zone, double time_s) {
    if (robots_watch_ == nullptr) return;
    const std::optional<ProcessId>& id = zones_.holder(zone);
    if (!id) return robots_watch_->give_zone(zone, time_s, std::nullopt);
    robots_watch_->give_zone(zone, time_s, simulation::RobotsWatch::Holder{*id, schedule_.process(*id).name});
}

/// Likewise: whose robot it is.
void Processes::tell_owner(const Control* control) {
    if (robots_watch_ == nullptr) return;
    const auto found = std::find(controls_.begin(), controls_.end(), control);
    robots_watch_->give_robot(static_cast<std::size_t>(found - controls_.begin()), now().time_s, running_);
}

}  // namespace gsim::script
