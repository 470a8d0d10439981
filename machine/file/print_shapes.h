#pragma once

#include "base/toml/toml_text.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Writes the key 'ignore', which stands before all tables; nothing where there are no pairs.
void print_ignored(base::TomlText& out, const Machine& machine);
/// Writes a table [[shape]] for each shape, meshes with their whole path.
void print_link_shapes(base::TomlText& out, const Machine& machine);

}  // namespace gsim::machine
