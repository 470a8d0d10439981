#include "runtime/simulator/program/program_zones.h"

#include <fmt/format.h>

namespace gsim::simulation {

void ProgramZones::set_data(const machine::MachineData& data) {
    monitor_.add_zones(data);
    for (const char letter : monitor_.missing_axes()) {
        warnings_.add(fmt::format("the machine has no linear axis {}; zones have no limits there", letter));
    }
}

}  // namespace gsim::simulation
