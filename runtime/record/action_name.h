#pragma once

#include <optional>
#include <string>

#include "runtime/simulation/report.h"

namespace gsim::record {

/// The action of a path (docs/paths.md) that an event of a run stands for: "waterjet_on" for jet_on, else the
/// event's kind with its detail ("digital_output P3 on"). None for what a program says or asks without
/// anything being switched: messages, prints, logs, inputs, probes.
std::optional<std::string> action_name(const simulation::Event& event);

/// A name as paths may have it: without control characters, at most 200 bytes.
std::string plain_name(std::string name);

}  // namespace gsim::record
