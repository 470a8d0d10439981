#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace gsim::machine {

/// The unit of lengths in part programs.
enum class ProgramUnits { mm, inch };

/// mm of a program unit: 1 or 25.4.
double unit_mm(ProgramUnits units);

/// What a machine file says of the programs that its control is given: the table [program].
struct ProgramTable {
    std::string dialect = {};  ///< A language or a control, as --dialect takes them; empty: not said.
    /// In force when a program begins; none: not said, which is mm.
    std::optional<ProgramUnits> units = std::nullopt;

    bool operator==(const ProgramTable&) const = default;
};

/// Reads that table alone: of all else in the file only that it is TOML. The error is "file:line:column:
/// sentence".
tl::expected<ProgramTable, std::string> read_program_table(std::string_view toml_text,
                                                           std::string_view file_name);

}  // namespace gsim::machine
