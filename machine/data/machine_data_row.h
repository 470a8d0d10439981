#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/error.h"
#include "machine/data/machine_data_sections.h"
#include "machine/data/machine_data_words.h"

namespace gsim::machine {

/// Word for a value that may be open (DataField::may_be_unlimited).
inline constexpr std::string_view kNoLimit = "-";

enum class LengthUnit { metric, inch };

/// An entry of a section, as it is written.
struct DataRow {
    std::string id;  ///< Number without leading zeros, code of a frame, or name of an alias.
    LengthUnit unit = LengthUnit::metric;
    /// One value for each field of the section's rules, as spelled; empty if it is not given. Options are in
    /// upper case, and '-' is a missing limit.
    std::vector<std::string> values;

    /// Returns the value of a numeric field, 0 if it is not given; in mm, deg or as it is.
    double number(const SectionRules& rules, std::size_t field) const;
};

/// A line read as an entry, and the assignment of its words to fields.
struct ParsedRow {
    DataRow row;
    std::vector<std::optional<std::size_t>> field_word_index;  ///< Index of the word.
    std::optional<std::size_t> unit_word_index;
};

/// Reads the words of a line, at least one. Does not detect duplicates. The error has the column, but not the
/// line.
Result<ParsedRow> read_row(const SectionRules& rules, std::span<const DataWord> words);

/// Returns the search key of an entry; equal sections and entries have one key. Names of aliases count
/// without regard to case.
std::string data_key(DataSection section, std::string_view id);

/// Returns the search key of an entry's name (DataField::is_name), without regard to case and different from
/// all data_key()s; nothing if it has no name.
std::optional<std::string> name_key(const SectionRules& rules, const DataRow& row);

/// Returns the entry's number, code or name as in keys and messages, or its error, as a message.
Result<std::string> read_id(const SectionRules& rules, std::string_view word);

/// Returns a line for an entry, without indentation and end.
std::string row_line(const SectionRules& rules, const DataRow& row);

/// Returns a value as written in a line: NAME=VALUE if the field is named.
std::string value_word(const DataField& field, std::string_view value);

}  // namespace gsim::machine
