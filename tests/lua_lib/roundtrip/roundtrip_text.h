#pragma once

#include <string>

#include "tests/lua_lib/roundtrip/roundtrip_model.h"

namespace gsim::roundtrip {

/// The program as G-code. The order of the words in a block, blanks, and where outer brackets that can be
/// left out stand all the same, are drawn from the seed.
std::string program_text(const Program& program, unsigned seed);

}  // namespace gsim::roundtrip
