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

/// Where an element in brackets stands, with the comments that are about it alone.
struct TomlElement {
    TomlBytes above;   ///< Whole lines of comments.
    TomlBytes value;   ///< Up to its comma, where that is on a later line.
    TomlBytes behind;  ///< A comment at the end of its line.
    TomlBytes lines;   ///< All of it where it has its lines to itself, else nothing.
};

/// The text of a document and where all in it stands, to be changed in single places. It knows no values: who
/// changes it says what is there by now, and reads the text again to see that it means what was wanted.
/// Where a change finds no place the text stays as it is.
class TomlSheet {
  public:
    /// Of a text that toml++ has read.
    explicit TomlSheet(std::string text);

    const std::string& text() const { return text_; }
    /// The value at `path` where it stands behind a key or in a list; null: it is a table on lines of its
    /// own, or there is none. Good up to the next change.
    const TomlSpot* find(const TomlPath& path) const;
    /// Whether anything in the text makes this table or list.
    bool makes(const TomlPath& path) const;

    /// Writes another value in the place of one that find() finds.
    void replace(const TomlPath& path, const nlohmann::ordered_json& value);
    /// A key that is not there, of a table that is.
    void add_key(const TomlPath& table, const std::string& key, const nlohmann::ordered_json& value);
    /// A further element of a list that find() finds, behind as many as `index`.
    void add_element(const TomlPath& list, std::size_t index, const nlohmann::ordered_json& value);
    /// A further table of an array of tables.
    void add_entry(const TomlPath& list, const nlohmann::ordered_json& table);
    void remove(const TomlPath& path);
    /// The element `from` of a list to the place `to` among the others.
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
