#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "machine/data/machine_data_sections.h"
#include "machine/data/machine_data_words.h"

namespace gsim::machine {

/// Stands for a value that may be open (DataField::may_be_open).
inline constexpr std::string_view kNoLimit = "-";

enum class LengthUnit { metric, inch };

/// An entry of a section, as it is written.
struct DataRow {
    std::string id;  ///< Number without leading zeros, code of a frame, or name of an alias.
    LengthUnit unit = LengthUnit::metric;
    /// One for each field of the section's rules, as spelled; empty where it is not given. Choices are in
    /// upper case, and '-' is a limit that is not there.
    std::vector<std::string> values;

    /// The value of a field that is a number, 0 where it is not given; in mm, deg or as it is.
    double number(const SectionRules& rules, std::size_t field) const;
};

/// What is wrong with a line, and where.
struct DataFault {
    std::size_t column = 1;
    std::string sentence;
};

/// A line read as an entry, and which of its words says what.
struct ReadRow {
    DataRow row;
    std::vector<std::optional<std::size_t>> word_of_field;  ///< Index of the word.
    std::optional<std::size_t> word_of_unit;
};

/// Reads the words of a line, of which there is one at least. Duplicates are not for it to find.
tl::expected<ReadRow, DataFault> read_row(const SectionRules& rules, std::span<const DataWord> words);

/// How an entry is looked up: sections and entries that are one have one key. Names of aliases count without
/// regard to case.
std::string data_key(DataSection section, std::string_view id);

/// How an entry is looked up by its name (DataField::is_name), without regard to case, apart from all
/// data_key()s; nothing where it has none.
std::optional<std::string> name_key(const SectionRules& rules, const DataRow& row);

/// The entry's number, code or name as keys and messages have it, or what is wrong with it, as a sentence.
tl::expected<std::string, std::string> read_id(const SectionRules& rules, std::string_view word);

/// A line for an entry, without indentation and end.
std::string row_line(const SectionRules& rules, const DataRow& row);

/// A value as it stands in a line: NAME=VALUE where the field is named.
std::string value_word(const DataField& field, std::string_view value);

}  // namespace gsim::machine
