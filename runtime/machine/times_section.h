#pragma once

#include "base/toml/toml_section.h"
#include "base/toml/toml_text.h"
#include "runtime/machine/word_times.h"

namespace gsim::machine {

/// The table [times]; null: there is none, and no word takes time.
WordTimes read_times(base::FirstError& error, const toml::table* table);

/// Writes it as it is read; nothing where no word takes time.
void print_times(base::TomlText& out, const WordTimes& times);

}  // namespace gsim::machine
