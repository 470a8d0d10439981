#pragma once

#include "runtime/machine/machine.h"
#include "runtime/machine/toml_text.h"

namespace gsim::machine {

/// Writes the key 'ignore', which stands before all tables; nothing where there are no pairs.
void print_ignored(TomlText& out, const Machine& machine);
/// Writes a table [[shape]] for each shape, meshes with their whole path.
void print_link_shapes(TomlText& out, const Machine& machine);

}  // namespace gsim::machine
