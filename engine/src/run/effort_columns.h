#pragma once

#include <memory>

#include "engine/columns.h"
#include "machine/model/machine.h"
#include "motion/dynamics/dynamics.h"
#include "runtime/outputs/run_output.h"

namespace gsim::engine {

/// Returns an output that delivers motor forces and torques as columns. `machine` and `dynamics` outlive it.
std::unique_ptr<simulation::RunOutput> make_efforts_output(EffortsHandler callback,
                                                           const machine::Machine& machine,
                                                           const dynamics::Dynamics& dynamics);

}  // namespace gsim::engine
