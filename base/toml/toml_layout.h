#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/toml/toml_path.h"

namespace gsim::base {

/// Bytes of a text, from `begin` up to `end`.
struct TomlRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

struct TomlItem;

/// A value as it is written.
struct TomlValueSpan {
    enum class Kind : std::uint8_t { plain, array, table };

    Kind kind = Kind::plain;
    TomlRange bytes;
    std::vector<TomlItem> items;  ///< Items of an array or inline table.
};

/// An element of an array, or a key with its value.
struct TomlItem {
    TomlPath key;  ///< Parts of the key; empty for an element.
    std::size_t begin = 0;
    std::size_t key_end = 0;
    TomlValueSpan value;
    std::size_t end = 0;  ///< End, past its comma if it has one.
};

/// The header of a table, or a key with its value on its own lines.
struct TomlStatement {
    enum class Kind : std::uint8_t { pair, table, entry };  ///< `a = 1`, `[a]`, `[[a]]`

    Kind kind = Kind::pair;
    TomlPath address;                ///< Path of the table or the value.
    std::size_t header = 0;          ///< Statement of a pair's table header, or kNoHeader.
    TomlItem item = {};              ///< Item of a pair.
    std::size_t above = 0;           ///< Start of the comments directly above it.
    std::size_t begin = 0, end = 0;  ///< Its complete lines.
    std::size_t below = 0;  ///< End of the comments directly below it that are not above another statement.

    bool is_pair() const { return kind == Kind::pair; }
};

/// Positions of everything in a document.
struct TomlLayout {
    static constexpr std::size_t kNoHeader = static_cast<std::size_t>(-1);

    std::size_t begin = 0;  ///< Past the UTF-8 byte order mark, if present.
    std::vector<TomlStatement> statements;
};

/// Returns the layout of a text that toml++ has read, or nothing if it seems not to be TOML.
std::optional<TomlLayout> parse_layout(std::string_view toml_text);

/// True if a text consists only of blanks and ends of lines.
bool is_blank(std::string_view text);

/// Returns the value to which `steps` leads from `value_span`; null if it does not exist.
const TomlValueSpan* find_nested_value(const TomlValueSpan& value_span, const TomlPath& steps);

}  // namespace gsim::base
