#pragma once

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Reads the tables [[group]] of a machine file, once its axes and inverse have been read.
void read_groups(base::FirstError& error, base::TomlSection& file, Machine& machine);
void print_groups(base::TomlWriter& out, const Machine& machine);

}  // namespace gsim::machine
