#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "base/toml/toml_path.h"
#include "base/toml/toml_sheet.h"

namespace gsim::base {

/// Editor of a document that people wrote. Comments, order, spacing, spellings of numbers and line ends stay
/// unless a change touches them. After each change the text is read again and must have the intended meaning.
/// A change that cannot be made returns a message and leaves the text unchanged.
class TomlEdit {
  public:
    using Done = tl::expected<void, std::string>;

    /// Reads a document. The error gives the position at which the text is not TOML: "file:line:column:
    /// message".
    static tl::expected<TomlEdit, std::string> read(std::string toml_text, std::string_view file_name);

    /// Sets the value of a key or an element, or adds a new key; missing tables on the path are made. Of
    /// objects and lists only the differences are changed. An element that stays in a list keeps its
    /// comments; a removed one takes them along. A number is written like the one before it, like its
    /// neighbours, or like those of the document: 254, else 254.0. "inf" in the position of a number is one.
    Done set(const TomlPath& path, const nlohmann::ordered_json& value);
    /// Adds an element at the end of a list; the first one makes the list.
    Done add(const TomlPath& list, const nlohmann::ordered_json& value);
    /// Removes a key, a table or an element, with everything below it and the comments directly above or
    /// after it. A comment above several keys or elements stays.
    Done remove(const TomlPath& path);
    /// Moves an element to the position `to` in its list, with its comments.
    Done move(const TomlPath& path, std::size_t to);

    const std::string& text() const { return sheet_.text(); }
    /// Returns the complete content of the document; dates, and numbers that are not finite, are texts.
    const nlohmann::json& value() const { return value_; }

  private:
    TomlEdit(TomlSheet sheet, nlohmann::json value) : sheet_(std::move(sheet)), value_(std::move(value)) {}

    const nlohmann::json* at(const TomlPath& path) const;
    nlohmann::json* at(const TomlPath& path);
    template <typename Change>
    Done whole(const Change& change);
    Done put(const TomlPath& path, const nlohmann::ordered_json& value);
    Done merge_objects(const TomlPath& path, const nlohmann::ordered_json& value);
    Done merge_lists(const TomlPath& path, const nlohmann::ordered_json& value);
    Done make(const TomlPath& path, const nlohmann::ordered_json& value);
    Done make_element(const TomlPath& list, std::size_t index, const nlohmann::ordered_json& value);
    Done arrange(const TomlPath& list, std::vector<std::optional<std::size_t>> places);
    Done insert(const TomlPath& list, std::size_t index, const nlohmann::ordered_json& value);
    Done take(const TomlPath& path);
    void shift(const TomlPath& list, std::size_t from, std::size_t to);

    TomlSheet sheet_;
    nlohmann::json value_;
};

}  // namespace gsim::base
