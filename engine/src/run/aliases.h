#pragma once

#include <string>

#include "base/error.h"
#include "lexer/alias.h"
#include "machine/data/machine_data.h"

namespace gsim::engine {

/// Returns the aliases of machine data in the form of the lexer; the error is a message.
Result<lexer::Aliases> make_aliases(const machine::MachineData& data);

}  // namespace gsim::engine
