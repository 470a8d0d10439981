#pragma once

#include <string>

namespace gsim::codegen {

/// Returns the reference of both dialects as Markdown (docs/language.md), from the tables of the translator.
/// It has every code by modal group with its words, its position in the order of execution and its Lua, the
/// letters, the functions, the O-words.
std::string language_page();

}  // namespace gsim::codegen
