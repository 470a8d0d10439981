#pragma once

#include <string>

#include <tl/expected.hpp>

#include "lexer/alias.h"
#include "machine/data/machine_data.h"

namespace gsim::engine {

/// Returns the aliases of machine data in the form of the lexer; the error is a message.
tl::expected<lexer::Aliases, std::string> make_aliases(const machine::MachineData& data);

}  // namespace gsim::engine
