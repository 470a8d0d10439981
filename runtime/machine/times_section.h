#pragma once

#include "runtime/machine/toml_section.h"
#include "runtime/machine/toml_text.h"
#include "runtime/machine/word_times.h"

namespace gsim::machine {

/// The table [times]; null: there is none, and no word takes time.
WordTimes read_times(FirstError& error, const toml::table* table);

/// Writes it as it is read; nothing where no word takes time.
void print_times(TomlText& out, const WordTimes& times);

}  // namespace gsim::machine
