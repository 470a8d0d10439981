#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "machine/model/machine.h"
#include "runtime/simulator/probe.h"

namespace gsim::engine {

/// Returns the contact of probes from Request::probe; empty: not given. The error is a message.
tl::expected<simulation::ProbeSurface, std::string> read_probe_options(std::string_view value,
                                                                       const machine::Machine& machine);

}  // namespace gsim::engine
