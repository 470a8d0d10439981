#pragma once

#include <cstdint>
#include <string>

#include "engine/api.h"

namespace gsim::engine {

/// Files written by people, for which forms are made.
enum class ConfigFileKind : std::uint8_t { machine, cell, controller };

/// Returns the tables and keys that such a file may have, with meanings, units, ranges and defaults: JSON, a
/// list of tables (docs/studio.md).
GSIM_API std::string file_keys_json(ConfigFileKind file);

}  // namespace gsim::engine
