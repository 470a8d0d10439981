#pragma once

// Only for readers of TOML files (toml_section.h).

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Reads [dynamics], [[mass]] and [[hose]] of a machine file. The machine has its axes and shapes already.
/// Their forces and masses without [dynamics] are an error.
void read_dynamics(base::FirstError& error, base::TomlSection& file, Machine& machine);

void print_dynamics(base::TomlWriter& out, const DynamicsTable& dynamics);

}  // namespace gsim::machine
