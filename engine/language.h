#pragma once

#include <string>

#include "engine/api.h"

namespace gsim::engine {

/// Returns both languages as JSON, from the tables that the translator uses: for each dialect its codes with
/// modal group, words and meaning, its letters, and the codes that are active at the start. For editors:
/// colours, completion, the meaning of a word (docs/studio.md).
GSIM_API std::string languages_json();

}  // namespace gsim::engine
