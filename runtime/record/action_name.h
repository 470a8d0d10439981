#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/report/report.h"

namespace gsim::record {

/// The action of a path (docs/paths.md) that an event of a run stands for: "waterjet_on" for jet_on, else the
/// event's kind with its detail ("digital_output P3 on", "message text"). None for what leaves nothing to be
/// done again: what a probe has found.
std::optional<std::string> action_name(const simulation::Event& event);

/// A number of an action's name: in digits without an exponent, to 1e-9.
std::string number_text(double value);

/// A name as paths may have it: UTF-8 without control characters, at most 200 bytes. A byte that is no UTF-8,
/// as of programs in other encodings, becomes a question mark.
std::string plain_name(std::string_view name);

}  // namespace gsim::record
