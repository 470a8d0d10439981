#pragma once

#include "base/toml/toml_section.h"
#include "base/toml/toml_text.h"
#include "machine/model/program_table.h"

namespace gsim::machine {

/// The table [program]; null: there is none.
ProgramTable read_program_section(base::FirstError& error, const toml::table* table);

/// Writes it as it is read; nothing where it says nothing.
void print_program_section(base::TomlText& out, const ProgramTable& program);

}  // namespace gsim::machine
