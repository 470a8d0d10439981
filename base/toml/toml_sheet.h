#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/json.h"
#include "base/toml/toml_json.h"
#include "base/toml/toml_layout.h"

namespace gsim::base {

/// Position of an element in brackets, with the comments that are only about it.
struct TomlElement {
    TomlBytes above;   ///< Complete lines of comments.
    TomlBytes value;   ///< Up to its comma, if that is on a later line.
    TomlBytes behind;  ///< A comment at the end of its line.
    TomlBytes lines;   ///< The full element if it has its own lines, else empty.
};

/// The text of a document and the positions in it, for changes of single parts. It does not know values: its
/// caller states the present content, and reads the text again to check its meaning. If a change finds no
/// position, the text stays as it is.
class TomlSheet {
  public:
    /// Takes a text that toml++ has read.
    explicit TomlSheet(std::string text);

    const std::string& text() const { return text_; }
    /// Returns the value at `path` if it is after a key or in a list. Null: it is a table on its own lines,
    /// or does not exist. Valid up to the next change.
    const TomlSpot* find(const TomlPath& path) const;
    /// True if anything in the text makes this table or list.
    bool makes(const TomlPath& path) const;

    /// Replaces a value that find() finds.
    void replace(const TomlPath& path, const nlohmann::ordered_json& value);
    /// Adds a key that does not exist to a table that does.
    void add_key(const TomlPath& table, const std::string& key, const nlohmann::ordered_json& value);
    /// Adds an element to a list that find() finds, after `index` elements.
    void add_element(const TomlPath& list, std::size_t index, const nlohmann::ordered_json& value);
    /// Adds a table to an array of tables.
    void add_entry(const TomlPath& list, const nlohmann::ordered_json& table);
    void remove(const TomlPath& path);
    /// Moves the element `from` of a list to the position `to`.
    void move(const TomlPath& list, std::size_t from, std::size_t to);

  private:
    void change(TomlBytes bytes, std::string_view text);
    std::string_view line_end() const;
    std::string_view between(std::size_t begin, std::size_t end) const;
    std::size_t line_begin(std::size_t at) const;

    TomlNumbers numbers_beside(const std::vector<const TomlSpot*>& spots) const;
    std::string value_beside(const nlohmann::ordered_json& value, const TomlSpot& spot) const;

    bool add_within(const TomlPath& table, const std::string& key, const nlohmann::ordered_json& value);
    void add_line(std::size_t head, const TomlPath& table, const std::string& key,
                  const nlohmann::ordered_json& value);
    void add_first_line(std::size_t head, const std::string& line);
    void add_item(const TomlSpot& spot, std::size_t behind, const std::string& item);
    bool add_below(const TomlSpot& spot, std::size_t index, const std::string& item);
    bool add_above(const TomlSpot& spot, std::size_t index, const std::string& item);
    std::string lines_of(const nlohmann::ordered_json& table, std::string_view indent) const;
    void add_block(std::size_t at, std::string block, bool apart);

    TomlElement element_of(const TomlSpot& spot, std::size_t index) const;
    TomlBytes comments_above(const TomlSpot& spot, std::size_t index, TomlBytes lines) const;
    void remove_item(const TomlSpot& spot, std::size_t index);
    bool remove_within(const TomlPath& path);
    TomlBytes lines_with(const TomlStatement& statement) const;
    TomlBytes section_bytes(std::size_t head) const;
    TomlBytes with_blank_lines(TomlBytes bytes) const;
    std::vector<TomlBytes> bytes_of(const TomlPath& path) const;
    std::string block_of(const TomlPath& entry) const;
    std::size_t end_of(const TomlPath& path) const;
    void move_item(const TomlSpot& spot, std::size_t from, std::size_t to);

    std::string text_;
    TomlLayout layout_;
};

}  // namespace gsim::base
