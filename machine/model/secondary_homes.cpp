#include "machine/model/secondary_homes.h"

namespace gsim::machine {

std::map<int, AxisValues> secondary_homes(const Machine& machine, const std::map<int, AxisValues>& stored) {
    std::map<int, AxisValues> homes = stored;
    for (const Axis& axis : machine.axes) {
        for (std::size_t i = 0; i < axis.other_homes.size(); ++i) {
            if (axis.other_homes[i])
                homes[static_cast<int>(i) + 2].try_emplace(axis.letter, *axis.other_homes[i]);
        }
    }
    return homes;
}

}  // namespace gsim::machine
