#pragma once

#include "runtime/machine/program_table.h"
#include "runtime/machine/toml_section.h"
#include "runtime/machine/toml_text.h"

namespace gsim::machine {

/// The table [program]; null: there is none.
ProgramTable read_program_section(FirstError& error, const toml::table* table);

/// Writes it as it is read; nothing where it says nothing.
void print_program_section(TomlText& out, const ProgramTable& program);

}  // namespace gsim::machine
