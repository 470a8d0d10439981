#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "toolpath/model/source_location.h"

namespace gsim::path {

/// TargetError in the form of a program, and its location.
struct TargetError {
    TargetId where;
    std::string message;
};

/// Returns the first error in the form of a program, whatever the machine: a path that leads back to itself
/// or is nested too deep, missing or double names, numbers out of range, invalid arcs. Time grows with the
/// number of targets, not with repeats.
std::optional<TargetError> validate(const Program& program);

}  // namespace gsim::path
