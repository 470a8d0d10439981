#pragma once

#include <map>
#include <optional>
#include <vector>

#include "toolpath/model/path.h"

namespace gsim::path {

/// Path to a position of the machine, in machine coordinates.
struct MachineApproach {
    int reference = 0;  ///< Above 0: a reference point, which the controller approaches by a special word.
    bool retract_first = false;  ///< The tool moves up first, as for a change.
    /// Axes that move there by a rapid, step by step, by letter, mm or deg. For an unknown reference point
    /// only the letters count.
    std::vector<std::map<char, double>> steps = {};
};

/// Returns the path to a point with its coordinates filled in, as far as they are known. The space in between
/// is unknown, so Z moves first if that leads up, to `retract_mm` or higher, otherwise last, from there. The
/// Z of an unknown reference point is taken to be up.
MachineApproach plan_approach(const MachinePoint& point, std::optional<double> retract_mm);

}  // namespace gsim::path
