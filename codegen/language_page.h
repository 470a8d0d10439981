#pragma once

#include <string>

namespace gsim::codegen {

/// The reference of both dialects as Markdown (docs/language.md), from the tables that the translator runs
/// by: every code by modal group with its words, its place in the order of execution and the Lua that it
/// becomes, the letters, the functions, the O-words.
std::string language_page();

}  // namespace gsim::codegen
