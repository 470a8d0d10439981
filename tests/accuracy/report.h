#pragma once

#include <span>
#include <string>

#include "tests/accuracy/outcome.h"

namespace gsim::accuracy {

enum class Format { plain, markdown };

/// The table of cycle times, the reasons for what was refused or is known to be off, and a line of figures.
std::string time_report(std::span<const TimeOutcome> outcomes, const Controller& controller, Format format);

/// Returns the same report for positions; empty without outcomes.
std::string path_report(std::span<const PathOutcome> outcomes, const Controller& controller, Format format);

}  // namespace gsim::accuracy
