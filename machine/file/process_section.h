#pragma once

#include <optional>

#include "base/toml/toml_section.h"
#include "machine/model/process.h"

namespace gsim::base {
class TomlText;
}

namespace gsim::machine {

/// The tables [process] and [checks] of a machine file, where it has them. Whether a language has the codes
/// is not looked at.
std::optional<Process> read_process(base::FirstError& error, base::TomlSection& file);

/// The same tables as text.
void print_process(base::TomlText& out, const Process& process);

}  // namespace gsim::machine
