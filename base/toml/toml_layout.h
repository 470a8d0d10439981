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
struct TomlBytes {
    std::size_t begin = 0;
    std::size_t end = 0;
};

struct TomlItem;

/// A value as it is written.
struct TomlSpot {
    enum class Kind : std::uint8_t { plain, array, table };

    Kind kind = Kind::plain;
    TomlBytes bytes;
    std::vector<TomlItem> items;  ///< Of an array or an inline table.
};

/// An element of an array, or a key with its value.
struct TomlItem {
    TomlPath key;  ///< Its parts; none of an element.
    std::size_t begin = 0;
    std::size_t key_end = 0;
    TomlSpot value;
    std::size_t end = 0;  ///< Behind its comma, where it has one.
};

/// A table's head, or a key with its value on lines of its own.
struct TomlStatement {
    enum class Kind : std::uint8_t { pair, table, entry };  ///< `a = 1`, `[a]`, `[[a]]`

    Kind kind = Kind::pair;
    TomlPath address;                ///< Of the table or the value.
    std::size_t head = 0;            ///< Of a pair: the statement of its table's head, or kNoHead.
    TomlItem item = {};              ///< Of a pair.
    std::size_t above = 0;           ///< Where the comments begin that stand directly above it.
    std::size_t begin = 0, end = 0;  ///< Its whole lines.
    std::size_t below = 0;  ///< Where the comments end that stand directly below it and above nothing.

    bool is_pair() const { return kind == Kind::pair; }
};

/// Where all in a document stands.
struct TomlLayout {
    static constexpr std::size_t kNoHead = static_cast<std::size_t>(-1);

    std::size_t begin = 0;  ///< Behind the mark of UTF-8, where there is one.
    std::vector<TomlStatement> statements;
};

/// The layout of a text that toml++ has read; nothing where it seems to be no TOML.
std::optional<TomlLayout> lay_out(std::string_view toml_text);

/// Whether a text is blanks and ends of lines alone.
bool is_blank(std::string_view text);

/// The value to which `steps` leads from `spot` on; null: none.
const TomlSpot* find_within(const TomlSpot& spot, const TomlPath& steps);

}  // namespace gsim::base
