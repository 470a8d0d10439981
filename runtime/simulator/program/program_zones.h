#pragma once

#include <optional>

#include "machine/data/machine_data.h"
#include "runtime/monitors/zone_monitor.h"
#include "runtime/simulator/program/target_ids.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Zones of a run as the program sets and switches them: each change holds from the next move on.
class ProgramZones {
  public:
    /// Begins without zones. All arguments must outlive this.
    ProgramZones(ZoneMonitor& monitor, const TargetIds& ids, Warnings& warnings)
        : monitor_(monitor), ids_(ids), warnings_(warnings) {}

    /// Activates the zones of machine data from time 0 on, before the first move. Warns of walls on axes that
    /// the machine does not have.
    void set_data(const machine::MachineData& data);
    /// Switches zones of machine data; returns false if no zone has the number.
    bool switch_zones(int switch_number, bool on) {
        return monitor_.switch_zones(switch_number, on, ids_.next());
    }
    /// Sets the zone of the program (ZoneMonitor::set_programmed()).
    void set_programmed(const std::optional<ZoneWalls>& walls) {
        monitor_.set_programmed(walls, ids_.next());
    }

  private:
    ZoneMonitor& monitor_;
    const TargetIds& ids_;
    Warnings& warnings_;
};

}  // namespace gsim::simulation
