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

/// Changes a document that people wrote. Comments, order, spacing, spellings of numbers and line ends stay
/// where a change does not touch them. After each change the text is read again, and means what was wanted;
/// what cannot be done is refused in a sentence, and has changed nothing.
class TomlEdit {
  public:
    using Done = tl::expected<void, std::string>;

    /// The error says where the text is no TOML: "file:line:column: sentence".
    static tl::expected<TomlEdit, std::string> read(std::string toml_text, std::string_view file_name);

    /// Gives a key or an element another value, or a new key one; tables that are lacking on the way are
    /// made. Of objects and lists only what differs is changed; an element that stays in a list keeps its
    /// comments, and one that goes takes them along. A number is written as the one before it,
    /// as those beside it, or as those of the document: 254, else 254.0. "inf" in the place of a number is
    /// one.
    Done set(const TomlPath& path, const nlohmann::ordered_json& value);
    /// A further element of a list, at its end; the first one makes the list.
    Done add(const TomlPath& list, const nlohmann::ordered_json& value);
    /// A key, a table or an element, with what is below it and the comments that stand directly above it or
    /// behind it. A comment above several keys or elements stays.
    Done remove(const TomlPath& path);
    /// An element to the place `to` among the others of its list, with its comments.
    Done move(const TomlPath& path, std::size_t to);

    const std::string& text() const { return sheet_.text(); }
    /// All that the document says; dates, and numbers that are not finite, as texts.
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
