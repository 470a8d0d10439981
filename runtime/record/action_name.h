#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/report/report.h"

namespace gsim::record {

/// Returns the action of a path (docs/paths.md) for an event of a run: "waterjet_on" for process_on,
/// otherwise the event's kind with its detail ("digital_output P3 on", "message text"). Nullopt for an event
/// that needs no repetition: what a probe has found.
std::optional<std::string> action_name(const simulation::Event& event);

/// Returns a number for an action's name: in digits without an exponent, to 1e-9.
std::string number_text(double value);

/// Returns a name as paths may have it: UTF-8 without control characters, at most 200 bytes. A byte that is
/// not UTF-8, as in programs in other encodings, becomes a question mark.
std::string sanitized_name(std::string_view name);

}  // namespace gsim::record
