#include "runtime/processes/shared_zones.h"

#include <algorithm>

namespace gsim::process {

std::optional<std::size_t> SharedZones::find(std::string_view name) const {
    const auto found =
        std::find_if(zones_.begin(), zones_.end(), [&](const Zone& zone) { return zone.name == name; });
    if (found == zones_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - zones_.begin());
}

std::vector<std::string_view> SharedZones::names() const {
    std::vector<std::string_view> names;
    names.reserve(zones_.size());
    for (const Zone& zone : zones_) names.emplace_back(zone.name);
    return names;
}

std::optional<std::size_t> SharedZones::note(const Process& process, const std::string& zone) {
    if (uses_.size() == kMaxListed) {
        ++dropped_;
        return std::nullopt;
    }
    uses_.push_back({.zone = zone,
                     .process = process.name,
                     .location = process.location,
                     .requested_s = process.time_s,
                     .from_s = std::nullopt,
                     .to_s = std::nullopt});
    return uses_.size() - 1;
}

void SharedZones::assign_to(Zone& zone, const ZoneRequest& to, double time_s) {
    zone.holder = to.process;
    zone.use = to.use;
    if (to.use) uses_[*to.use].from_s = time_s;
}

bool SharedZones::enter(Schedule& schedule, std::size_t index, ProcessId id) {
    Zone& zone = zones_[index];
    const Process& process = schedule.process(id);
    const ZoneRequest request{id, note(process, zone.name)};
    if (!zone.holder) {
        assign_to(zone, request, process.time_s);
        return true;
    }
    zone.pending.push_back(request);
    schedule.wait(id, {.kind = WaitKind::zone, .signal = zone.name, .holder = zone.holder});
    return false;
}

std::optional<ProcessId> SharedZones::leave(Schedule& schedule, std::size_t index) {
    Zone& zone = zones_[index];
    const double time_s = schedule.process(*zone.holder).time_s;
    if (zone.use) uses_[*zone.use].to_s = time_s;
    zone.holder.reset();
    zone.use.reset();
    if (zone.pending.empty()) return std::nullopt;
    const ZoneRequest next = zone.pending.front();
    zone.pending.pop_front();
    assign_to(zone, next, time_s);
    schedule.wake(next.process, time_s);
    for (const ZoneRequest& pending : zone.pending)
        schedule.process(pending.process).wait.holder = next.process;
    return next.process;
}

}  // namespace gsim::process
