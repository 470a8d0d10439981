#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/toml/toml_section.h"
#include "base/toml/toml_text.h"
#include "machine/model/word_times.h"

namespace gsim::machine {

/// The table [times]; null: there is none, and no word takes time.
WordTimes read_times(base::FirstError& error, const toml::table* table);

/// The time that a key of the table is for; null: it is none of the named ones, nor a code that the table
/// has.
double* time_at(std::string_view key, WordTimes& times);
const double* time_at(std::string_view key, const WordTimes& times);

/// The keys of the table but those of codes.
std::vector<std::string> named_time_keys();
/// The keys of all times that are more than 0, those of codes behind the others.
std::vector<std::string> timed_keys(const WordTimes& times);

/// Writes it as it is read; nothing where no word takes time.
void print_times(base::TomlText& out, const WordTimes& times);

}  // namespace gsim::machine
