#pragma once

#include <optional>

#include "runtime/machine/process.h"
#include "runtime/machine/toml_section.h"

namespace gsim::machine {

class TomlText;

/// The tables [process] and [checks] of a machine file, where it has them. Whether a language has the codes
/// is not looked at.
std::optional<Process> read_process(FirstError& error, TomlSection& file);

/// The same tables as text.
void print_process(TomlText& out, const Process& process);

}  // namespace gsim::machine
