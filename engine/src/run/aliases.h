#pragma once

#include <string>

#include <tl/expected.hpp>

#include "lexer/alias.h"
#include "machine/data/machine_data.h"

namespace gsim::engine {

/// The aliases of machine data as the lexer takes them; the error is a sentence.
tl::expected<lexer::Aliases, std::string> aliases_of(const machine::MachineData& data);

}  // namespace gsim::engine
