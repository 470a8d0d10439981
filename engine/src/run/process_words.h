#pragma once

#include <optional>
#include <string>

#include "grammar/dialect.h"
#include "machine/model/process.h"

namespace gsim::engine {

/// Returns a message if the words that switch a machine's process cannot be those of any dialect; nothing if
/// each is a code of one of them, including user codes (from M100 on).
std::optional<std::string> check_process(const machine::Process& process);

/// Returns a message if a program of this dialect cannot switch the process; nothing if it can, on and off.
std::optional<std::string> check_process(const machine::Process& process, const grammar::Dialect& dialect);

}  // namespace gsim::engine
