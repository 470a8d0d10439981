#pragma once

#include <cstddef>
#include <vector>

#include "runtime/processes/shared_zones.h"
#include "runtime/script/processes/known_motion.h"
#include "runtime/script/processes/process_robots.h"
#include "runtime/script/processes/process_table.h"

namespace gsim::script {

/// Shared zones as processes see them: which process has one, and which waits for it.
class ProcessZones {
  public:
    /// `table`, `robots` and `known_motion` must outlive this.
    ProcessZones(ProcessTable& table, const ProcessRobots& robots, const KnownMotion& known_motion)
        : table_(table), robots_(robots), known_motion_(known_motion) {}

    /// Sets the zones that processes share, before the first process is started.
    void set_zones(const std::vector<process::SharedZone>& zones) { zones_ = process::SharedZones(zones); }
    const process::SharedZones& shared_zones() const { return zones_; }
    /// Returns true if the running process has the zone.
    bool has(std::size_t zone) const { return zones_.holder(zone) == table_.running_id(); }
    /// Waits until the running process has the zone, which it does not have yet. Raises an alarm if that can
    /// never be.
    int enter(lua_State* state, std::size_t zone);
    /// Releases the zone, which the running process has.
    void leave(std::size_t zone);

  private:
    void notify_holder(std::size_t zone) const;

    ProcessTable& table_;
    const ProcessRobots& robots_;
    const KnownMotion& known_motion_;
    process::SharedZones zones_;
};

}  // namespace gsim::script
