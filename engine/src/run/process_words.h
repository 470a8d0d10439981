#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "grammar/dialect.h"
#include "machine/model/process.h"

namespace gsim::engine {

/// Returns an error if the words that switch a machine's process cannot be those of any dialect: each must be
/// a code of one of them, including user codes (from M100 on).
std::optional<gsim::Error> find_process_error(const machine::Process& process);

/// Returns an error if a program of this dialect cannot switch the process on and off.
std::optional<gsim::Error> find_process_error(const machine::Process& process,
                                              const grammar::Dialect& dialect);

}  // namespace gsim::engine
