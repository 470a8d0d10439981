#pragma once

#include <string>

#include "machine/model/machine.h"
#include "motion/segment/segment.h"

namespace gsim::simulation {

/// Returns what limited a move, for reports: "feed", "joint X speed", "rotary B acceleration", ...
/// (docs/report.md).
std::string describe(motion::LimitCause limited_by, const machine::Machine& machine);

}  // namespace gsim::simulation
