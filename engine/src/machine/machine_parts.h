#pragma once

#include <memory>

#include "engine/machine.h"
#include "engine/src/run/run_inputs.h"

namespace gsim::engine {

/// Data shared by runs on a machine.
struct Machine::Parts {
    ResolvedRequest found;  ///< Machine, machine data and cell alone.
    MachineInput input;
    std::shared_ptr<const cell::Cell> bodies = nullptr;  ///< Null: not read.
};

}  // namespace gsim::engine
