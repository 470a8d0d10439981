#pragma once

#include "base/toml/toml_writer.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Writes the key 'ignore', which comes before all tables; writes nothing if no pairs exist.
void print_ignored(base::TomlWriter& out, const Machine& machine);
/// Writes a table [[shape]] for each shape, meshes with their full path.
void print_link_shapes(base::TomlWriter& out, const Machine& machine);

}  // namespace gsim::machine
