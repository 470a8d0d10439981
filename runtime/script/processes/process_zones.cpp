#include "runtime/script/processes/process_zones.h"

#include <fmt/format.h>

namespace gsim::script {

using text::DiagnosticKind;

using process::ProcessId;

int ProcessZones::enter(lua_State* state, std::size_t zone) {
    process::Schedule& schedule = table_.schedule();
    if (zones_.enter(schedule, zone, table_.running_id())) {
        notify_holder(zone);
        return 0;
    }
    if (const std::vector<ProcessId> deadlocked = schedule.deadlocked_from(table_.running_id());
        !deadlocked.empty()) {
        robots_.alarm(state, DiagnosticKind::process,
                      fmt::format("deadlock: {}",
                                  schedule.waits(robots_.interpreter().simulator().program().files().names(),
                                                 deadlocked)));
    }
    return table_.yield(state, YieldReason::in_wait);
}

void ProcessZones::leave(std::size_t zone) {
    zones_.leave(table_.schedule(), zone);
    notify_holder(zone);
}

/// Notifies the monitor that checks for robots in zones of others.
void ProcessZones::notify_holder(std::size_t zone) const {
    known_motion_.on_zone_holder(zone, table_.running().time_s, zones_.holder(zone));
}

}  // namespace gsim::script
