#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "machine/model/machine.h"
#include "runtime/simulator/probe.h"

namespace gsim::engine {

/// Returns the contact of probes from Request::probe; empty: not given.
Result<simulation::ProbeSurface> read_probe_options(std::string_view value, const machine::Machine& machine);

}  // namespace gsim::engine
