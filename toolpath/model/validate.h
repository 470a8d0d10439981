#pragma once

#include <optional>
#include <string>

#include "toolpath/model/source_location.h"

namespace gsim::path {

/// Error in the form of a program, and its location.
struct Error {
    TargetId where;
    std::string message;
};

/// Returns the first error in the form of a program, whatever the machine: a path that leads back to itself
/// or is nested too deep, missing or double names, numbers out of range, invalid arcs. Returns nullopt if it
/// is well formed. Time grows with the number of targets, not with repeats.
std::optional<Error> validate(const Program& program);

}  // namespace gsim::path
