#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/host.h"

namespace gsim::engine {

/// A TOML file (of a machine, a cell, a controller) with changes applied.
struct EditedToml {
    std::string text;
    std::string json;  ///< All that it says; dates, and numbers that are not finite, as texts.
};

/// Returns the text of a file with changes applied, all of them or none; a missing file counts as an empty
/// one. Unchanged parts stay as they were written: comments, order, spacing, spellings of numbers, line ends.
/// `changes` are JSON, a list of {"op": "set", "at": ["axis", 0, "max_mm"], "value": 600}, {"op": "add",
/// "at": ["object"], "value": {...}}, {"op": "remove", "at": [...]} and {"op": "move", "at": ["axis", 2],
/// "to": 0}. Keys of new tables are inserted in the order of docs/machine-file.md and docs/cell-file.md. If
/// the file is no TOML, `on_diagnostic` receives the source location. The file itself is not written.
GSIM_API tl::expected<EditedToml, Error> edited_toml(const Host& host, const std::string& name,
                                                     std::string_view changes,
                                                     const DiagnosticHandler& on_diagnostic = {});

}  // namespace gsim::engine
