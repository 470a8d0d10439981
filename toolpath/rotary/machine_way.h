#pragma once

#include <map>
#include <optional>
#include <vector>

#include "toolpath/model/path.h"

namespace gsim::path {

/// A way to a place of the machine, in machine coordinates.
struct MachineWay {
    int reference = 0;  ///< Above 0: a reference point, to which the control goes by its own word for it.
    bool from_above = false;  ///< The tool goes up first, as to be changed.
    /// The axes that go there by a rapid, one step after the other, by letter, mm or deg. Of a reference
    /// point that nobody knows the letters alone count.
    std::vector<std::map<char, double>> steps = {};
};

/// The way to a point whose coordinates are filled in, as far as they are known. What lies between nobody
/// knows: Z goes first where that leads up, to `up_mm` or higher, else last, from there. The Z of a reference
/// point that nobody knows is taken to be up.
MachineWay way_to(const MachinePoint& point, std::optional<double> up_mm);

}  // namespace gsim::path
