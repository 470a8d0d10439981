#pragma once

#include <vector>

#include "grammar/dialect.h"
#include "runtime/script/lua/script.h"

namespace gsim::engine {

/// Returns the codes of a dialect in the form of the Lua library, without user codes.
std::vector<script::CodeRow> word_table(const grammar::Dialect& dialect);

}  // namespace gsim::engine
