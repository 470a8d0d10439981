#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace gsim::machine {

/// The unit of lengths in part programs.
enum class ProgramUnits { mm, inch };

/// Returns the mm of a program unit: 1 or 25.4.
double unit_mm(ProgramUnits units);

/// Data of a machine file about the programs for its controller: the table [program].
struct ProgramTable {
    std::string dialect = {};  ///< A language or a controller, as --dialect takes them; empty: not given.
    /// Active when a program begins; none: not given, which is mm.
    std::optional<ProgramUnits> units = std::nullopt;

    bool operator==(const ProgramTable&) const = default;
};

/// Reads only that table; of the remaining file it only checks that it is TOML. The error is
/// "file:line:column: message".
Result<ProgramTable> read_program_table(std::string_view toml_text, std::string_view file_name);

}  // namespace gsim::machine
