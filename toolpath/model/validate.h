#pragma once

#include <optional>
#include <string>

#include "toolpath/model/place.h"

namespace gsim::path {

/// What is ill formed in a program, and where.
struct Fault {
    TargetId where;
    std::string sentence;
};

/// The first thing that makes a program ill formed, whatever the machine: a path that leads back to itself or
/// is nested too deep, names that are missing or double, numbers out of range, arcs that are none. Nothing if
/// it is well formed. Time grows with the number of targets, not with repeats.
std::optional<Fault> validate(const Program& program);

}  // namespace gsim::path
