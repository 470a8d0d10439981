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
    TomlRange above;  ///< Complete lines of comments.
    TomlRange value;  ///< Up to its comma, if that is on a later line.
    TomlRange after;  ///< A comment at the end of its line.
    TomlRange lines;  ///< The full element if it has its own lines, else empty.
};

/// The text of a document and the positions in it, for changes of single parts. It does not know values: its
/// caller states the present content, and reads the text again to check its meaning. If a change finds no
/// position, the text stays as it is.
class TomlTextEditor {
  public:
    /// Takes a text that toml++ has read.
    explicit TomlTextEditor(std::string text);

    const std::string& text() const { return text_; }
    /// Returns the value at `path` if it follows a key or is in a list. Null: it is a table on its own lines,
    /// or does not exist. Valid up to the next change.
    const TomlValueSpan* find(const TomlPath& path) const;
    /// True if anything in the text makes this table or list.
    bool defines(const TomlPath& path) const;

    /// Replaces a value that find() finds.
    void replace(const TomlPath& path, const nlohmann::ordered_json& value);
    /// Adds a key that does not exist to a table that does.
    void add_key(const TomlPath& table, const std::string& key, const nlohmann::ordered_json& value);
    /// Adds an element to a list that find() finds, at the position `index`.
    void add_element(const TomlPath& list, std::size_t index, const nlohmann::ordered_json& value);
    /// Adds a table to an array of tables.
    void add_entry(const TomlPath& list, const nlohmann::ordered_json& table);
    void remove(const TomlPath& path);
    /// Moves the element `from` of a list to the position `to`.
    void move(const TomlPath& list, std::size_t from, std::size_t to);

  private:
    void change(TomlRange bytes, std::string_view text);
    std::string_view line_end() const;
    std::string_view between(std::size_t begin, std::size_t end) const;
    std::size_t line_begin(std::size_t at) const;

    TomlNumbers neighbor_number_style(const std::vector<const TomlValueSpan*>& value_spans) const;
    std::string value_like_neighbors(const nlohmann::ordered_json& value,
                                     const TomlValueSpan& value_span) const;

    bool add_inline(const TomlPath& table, const std::string& key, const nlohmann::ordered_json& value);
    void add_line(std::size_t header, const TomlPath& table, const std::string& key,
                  const nlohmann::ordered_json& value);
    void add_first_line(std::size_t header, const std::string& line);
    void add_item(const TomlValueSpan& value_span, std::size_t after, const std::string& item);
    bool add_below(const TomlValueSpan& value_span, std::size_t index, const std::string& item);
    bool add_above(const TomlValueSpan& value_span, std::size_t index, const std::string& item);
    std::string table_lines(const nlohmann::ordered_json& table, std::string_view indent) const;
    void add_block(std::size_t at, std::string block, bool separated);

    TomlElement element_at(const TomlValueSpan& value_span, std::size_t index) const;
    TomlRange comments_above(const TomlValueSpan& value_span, std::size_t index, TomlRange lines) const;
    void remove_item(const TomlValueSpan& value_span, std::size_t index);
    bool remove_within(const TomlPath& path);
    TomlRange lines_with(const TomlStatement& statement) const;
    TomlRange section_bytes(std::size_t header) const;
    TomlRange with_blank_lines(TomlRange bytes) const;
    std::vector<TomlRange> byte_ranges(const TomlPath& path) const;
    std::string entry_block(const TomlPath& entry) const;
    std::size_t section_end(const TomlPath& path) const;
    void move_item(const TomlValueSpan& value_span, std::size_t from, std::size_t to);

    std::string text_;
    TomlLayout layout_;
};

}  // namespace gsim::base
