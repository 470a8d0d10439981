#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/text/json.h"
#include "base/toml/toml_path.h"
#include "base/toml/toml_text_editor.h"

namespace gsim::base {

/// Editor of a document that people wrote. Comments, order, spacing, spellings of numbers and line ends stay
/// unless a change touches them. After each change the text is read again and must have the intended meaning.
/// A change that cannot be made returns a message and leaves the text unchanged.
class TomlEditor {
  public:
    /// Reads a document. The error gives the position where the text is not TOML: "file:line:column:
    /// message".
    static Result<TomlEditor> read(std::string toml_text, std::string_view file_name);

    /// Sets the value of a key or an element, or adds a new key; missing tables on the path are made. Of
    /// objects and lists only the differences are changed. An element that stays in a list keeps its
    /// comments; a removed one takes them along. A number is written like the one before it, like its
    /// neighbours, or like those of the document: 254, else 254.0. "inf" in the position of a number is one.
    Result<void> set(const TomlPath& path, const nlohmann::ordered_json& value);
    /// Adds an element at the end of a list; the first one makes the list.
    Result<void> add(const TomlPath& list, const nlohmann::ordered_json& value);
    /// Removes a key, a table or an element, with everything below it and the comments directly above or
    /// following it. A comment above several keys or elements stays.
    Result<void> remove(const TomlPath& path);
    /// Moves an element to the position `to` in its list, with its comments.
    Result<void> move(const TomlPath& path, std::size_t to);

    const std::string& text() const { return text_editor_.text(); }
    /// Returns the complete content of the document; dates, and numbers that are not finite, are texts.
    const nlohmann::json& value() const { return value_; }

  private:
    TomlEditor(TomlTextEditor editor, nlohmann::json value)
        : text_editor_(std::move(editor)), value_(std::move(value)) {}

    const nlohmann::json* at(const TomlPath& path) const;
    nlohmann::json* at(const TomlPath& path);
    template <typename Change>
    Result<void> apply_atomically(const Change& change);
    Result<void> write_value(const TomlPath& path, const nlohmann::ordered_json& value);
    Result<void> merge_objects(const TomlPath& path, const nlohmann::ordered_json& value);
    Result<void> merge_lists(const TomlPath& path, const nlohmann::ordered_json& value);
    Result<void> make(const TomlPath& path, const nlohmann::ordered_json& value);
    Result<void> make_element(const TomlPath& list, std::size_t index, const nlohmann::ordered_json& value);
    Result<void> arrange(const TomlPath& list, std::vector<std::optional<std::size_t>> new_indices);
    Result<void> insert(const TomlPath& list, std::size_t index, const nlohmann::ordered_json& value);
    Result<void> remove_value(const TomlPath& path);
    void shift(const TomlPath& list, std::size_t from, std::size_t to);

    TomlTextEditor text_editor_;
    nlohmann::json value_;
};

}  // namespace gsim::base
