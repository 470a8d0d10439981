#pragma once

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/program_table.h"

namespace gsim::machine {

/// Reads the table [program]; null: it does not exist.
ProgramTable read_program_section(base::FirstError& error, const toml::table* table);

/// Writes it as it is read; writes nothing if it is empty.
void print_program_section(base::TomlWriter& out, const ProgramTable& program);

}  // namespace gsim::machine
