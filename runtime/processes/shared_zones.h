#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/services/types.h"
#include "machine/model/link_shape.h"
#include "runtime/processes/schedule.h"
#include "runtime/report/report.h"

namespace gsim::process {

/// Part of the common world in which one robot may be at a time.
struct SharedZone {
    std::string name;
    machine::ShapeForm form;  ///< No mesh.
    rrs::CartPos frame = rrs::CartPos::Identity();
};

/// Owners of the shared zones, and the processes that wait for them: in the order of their requests.
class SharedZones {
  public:
    /// Max number of uses in a report; further ones are counted.
    static constexpr std::size_t kMaxListed = 10'000;

    explicit SharedZones(const std::vector<SharedZone>& zones = {}) : zones_(zones.begin(), zones.end()) {}

    std::size_t size() const { return zones_.size(); }
    const std::string& name(std::size_t zone) const { return zones_[zone].name; }
    std::optional<std::size_t> find(std::string_view name) const;
    std::vector<std::string_view> names() const;
    const std::optional<ProcessId>& holder(std::size_t zone) const { return zones_[zone].holder; }

    /// Requests the zone for the process at its time; returns true if it has it at once. Otherwise it waits
    /// in the schedule until it has the zone.
    bool enter(Schedule& schedule, std::size_t zone, ProcessId process);
    /// Releases the zone of its process at the time of that process; returns the next one that has it then.
    std::optional<ProcessId> leave(Schedule& schedule, std::size_t zone);

    const std::vector<simulation::ZoneUse>& uses() const { return uses_; }
    std::uint64_t dropped() const { return dropped_; }

  private:
    struct ZoneRequest {
        ProcessId process;
        std::optional<std::size_t> use;  ///< Index in uses_, if it is listed.
    };
    struct Zone {
        explicit Zone(const SharedZone& of) : name(of.name) {}

        std::string name;
        std::optional<ProcessId> holder = {};
        std::optional<std::size_t> use = {};  ///< Use by the holder.
        std::deque<ZoneRequest> pending = {};
    };

    std::optional<std::size_t> note(const Process& process, const std::string& zone);
    void assign_to(Zone& zone, const ZoneRequest& to, double time_s);

    std::vector<Zone> zones_;
    std::vector<simulation::ZoneUse> uses_;
    std::uint64_t dropped_ = 0;
};

}  // namespace gsim::process
