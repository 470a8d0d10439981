#pragma once

#include <optional>

#include "base/toml/toml_section.h"
#include "machine/model/process.h"

namespace gsim::base {
class TomlWriter;
}

namespace gsim::machine {

/// Reads the tables [process] and [checks] of a machine file, if it has them. Does not check if a language
/// has the codes.
std::optional<Process> read_process(base::FirstError& error, base::TomlSection& file);

/// Writes the same tables as text.
void print_process(base::TomlWriter& out, const Process& process);

}  // namespace gsim::machine
