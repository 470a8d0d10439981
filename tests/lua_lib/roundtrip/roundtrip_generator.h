#pragma once

#include "tests/lua_lib/roundtrip/roundtrip_model.h"

namespace gsim::roundtrip {

/// A random program that translates and runs without an alarm, with as many subs and statements as a page
/// holds.
Program random_program(Dialect dialect, unsigned seed);

}  // namespace gsim::roundtrip
