#pragma once

#include <optional>
#include <string>

#include "grammar/dialect.h"
#include "machine/model/process.h"

namespace gsim::engine {

/// Why the words that switch a machine's process cannot be those of any dialect, as a sentence; nothing where
/// each is a code of one of them, user codes (from M100 on) among these.
std::optional<std::string> fault_of_process(const machine::Process& process);

/// Why a program of this dialect cannot switch the process, as a sentence; nothing where it can, on and off.
std::optional<std::string> fault_of_process(const machine::Process& process, const grammar::Dialect& dialect);

}  // namespace gsim::engine
