#pragma once

#include <memory>

#include "engine/columns.h"
#include "runtime/dynamics/dynamics.h"
#include "runtime/simulation/run_output.h"

namespace gsim::engine {

/// An output that hands out what the motors bring up as columns. `dynamics` outlives it.
std::unique_ptr<simulation::RunOutput> hand_out_efforts(TakeEfforts take, const dynamics::Dynamics& dynamics);

}  // namespace gsim::engine
