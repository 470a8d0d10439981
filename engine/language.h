#pragma once

#include <string>

#include "engine/api.h"

namespace gsim::engine {

/// Both languages as JSON, from the tables that the translator runs by: for each dialect its codes with
/// modal group, words and meaning, its letters, and what is in force at the start. For editors: colours,
/// completion, what a word does (docs/studio.md).
GSIM_API std::string languages_json();

}  // namespace gsim::engine
