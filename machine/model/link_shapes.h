#pragma once

#include <filesystem>

#include "base/os/files.h"
#include "base/toml/toml_section.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Reads the shapes of a machine file, [[shape]], and the pairs of them under 'ignore'. The machine has its
/// axes already. Meshes are searched in `folder`.
void read_link_shapes(base::FirstError& error, base::TomlSection& file, const toml::table& root,
                      const std::filesystem::path& folder, const os::Files& files, Machine& machine);

}  // namespace gsim::machine
