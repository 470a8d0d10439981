#pragma once

#include <optional>
#include <string>

#include "toolpath/model/place.h"

namespace gsim::path {

/// Error in the form of a program, and its location.
struct Fault {
    TargetId where;
    std::string sentence;
};

/// Returns the first error in the form of a program, whatever the machine: a path that leads back to itself
/// or is nested too deep, missing or double names, numbers out of range, invalid arcs. Returns nullopt if it
/// is well formed. Time grows with the number of targets, not with repeats.
std::optional<Fault> validate(const Program& program);

}  // namespace gsim::path
