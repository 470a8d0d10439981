#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/word_times.h"

namespace gsim::machine {

/// Reads the table [times]; null: it does not exist, and no word takes time.
WordTimes read_times(base::FirstError& error, const toml::table* table);

/// Returns the time for a key of the table; null: it is neither a named key nor a code in the table.
double* word_time(std::string_view key, WordTimes& times);
const double* word_time(std::string_view key, const WordTimes& times);

/// Returns the keys of the table, except those of codes.
std::vector<std::string> named_time_keys();
/// Returns the keys of all times above 0, those of codes last.
std::vector<std::string> nonzero_time_keys(const WordTimes& times);

/// Writes it as it is read; writes nothing if no word takes time.
void print_times(base::TomlWriter& out, const WordTimes& times);

}  // namespace gsim::machine
