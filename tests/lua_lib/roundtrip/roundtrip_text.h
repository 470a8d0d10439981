#pragma once

#include <string>

#include "tests/lua_lib/roundtrip/roundtrip_model.h"

namespace gsim::roundtrip {

/// Returns the program as G-code. The seed decides the order of the words in a block, the blanks, and which
/// optional outer brackets are written.
std::string program_text(const Program& program, unsigned seed);

}  // namespace gsim::roundtrip
