#pragma once

#include <vector>

#include "grammar/dialect.h"
#include "runtime/script/lua/script.h"

namespace gsim::engine {

/// The codes of a dialect as the library in Lua takes them; of user codes there are none.
std::vector<script::CodeRow> word_table(const grammar::Dialect& dialect);

}  // namespace gsim::engine
