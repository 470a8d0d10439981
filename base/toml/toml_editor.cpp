#include "base/toml/toml_editor.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/toml/toml_bounds.h"
#include "base/toml/toml_match.h"

namespace gsim::base {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kCannotEdit = "this change is not possible in the text as it is written";

std::string_view value_type_text(const json& value) {
    if (value.is_object()) return "a table";
    if (value.is_array()) return "a list";
    if (value.is_string()) return "a string";
    return value.is_number() ? "a number" : "true or false";
}

Unexpected list_element_error(const TomlPath& list, const json& value) {
    return Unexpected(fmt::format("'{}' is a list of tables; {} cannot be an element of it",
                                  display_text(list), value_type_text(value)));
}

TomlPath path_prefix(const TomlPath& path, std::size_t steps = 1) {
    return {path.begin(), path.end() - static_cast<std::ptrdiff_t>(steps)};
}

std::optional<Error> find_path_error(const TomlPath& path) {
    if (path.size() <= kMaxTomlBrackets) return std::nullopt;
    return fmt::format("a path may lead through at most {} tables and lists", kMaxTomlBrackets);
}

/// Returns the value inside the tables and lists of the path from step `first` on; nothing if a list would
/// need elements before it.
std::optional<ordered_json> wrap_in_tables(const TomlPath& path, std::size_t first, ordered_json value) {
    for (std::size_t i = path.size(); i-- > first;) {
        if (const auto* index = std::get_if<std::size_t>(&path[i])) {
            if (*index != 0) return std::nullopt;
            value = ordered_json::array({std::move(value)});
        } else {
            value = ordered_json{{std::get<std::string>(path[i]), std::move(value)}};
        }
    }
    return value;
}

}  // namespace

Result<TomlEditor> TomlEditor::read(std::string toml_text, std::string_view file_name) {
    auto value = toml_json(toml_text, file_name);
    if (!value) return tl::unexpected(value.error());
    return TomlEditor(TomlTextEditor(std::move(toml_text)), *std::move(value));
}

const json* TomlEditor::at(const TomlPath& path) const {
    const json* value = &value_;
    for (const TomlStep& step : path) {
        if (const auto* index = std::get_if<std::size_t>(&step)) {
            if (!value->is_array() || *index >= value->size()) return nullptr;
            value = &(*value)[*index];
        } else {
            const auto& key = std::get<std::string>(step);
            if (!value->is_object() || !value->contains(key)) return nullptr;
            value = &(*value)[key];
        }
    }
    return value;
}

json* TomlEditor::at(const TomlPath& path) {
    return const_cast<json*>(std::as_const(*this).at(path));
}

// A change is made completely or not at all, and the text then has the intended meaning.
template <typename Change>
Result<void> TomlEditor::apply_atomically(const Change& change) {
    TomlEditor before = *this;
    Result<void> done = change();
    if (done) {
        auto read = toml_json(text(), "the changed text");
        if (read && *read == value_) {
            value_ = *std::move(read);
            return {};
        }
        done = Unexpected(read ? kCannotEdit : read.error().message);
    }
    *this = std::move(before);
    return done;
}

Result<void> TomlEditor::set(const TomlPath& path, const ordered_json& value) {
    if (const auto error = find_path_error(path)) return Unexpected(*error);
    if (const auto error = find_value_error(value)) return Unexpected(*error);
    if (path.empty() && !value.is_object()) return Unexpected("a document must be a table, with keys");
    return apply_atomically([&]() -> Result<void> {
        if (Result<void> done = write_value(path, value); !done) return done;
        const json* const now = at(path);
        if (now != nullptr && *now == json(value)) return {};
        return Unexpected(
            fmt::format("'{}' is created by its entries; an empty one is removed", display_text(path)));
    });
}

Result<void> TomlEditor::write_value(const TomlPath& path, const ordered_json& value) {
    const json* const old = at(path);
    if (old == nullptr) return make(path, value);
    if (*old == json(value)) return {};
    if (old->is_object() && value.is_object()) return merge_objects(path, value);
    if (old->is_array() && value.is_array()) return merge_lists(path, value);
    if (text_editor_.find(path) == nullptr) {
        return Unexpected(fmt::format("'{}' is {} on separate lines; {} cannot replace it",
                                      display_text(path), value_type_text(*old), value_type_text(value)));
    }
    text_editor_.replace(path, value);
    *at(path) = value;
    return {};
}

Result<void> TomlEditor::merge_objects(const TomlPath& path, const ordered_json& value) {
    std::vector<std::string> removed;
    for (const auto& [key, old] : at(path)->items()) {
        if (!value.contains(key)) removed.push_back(key);
    }
    for (const auto& [key, requested] : value.items()) {
        if (Result<void> done = write_value(below(path, key), requested); !done) return done;
    }
    for (const std::string& key : removed) {
        if (Result<void> done = remove_value(below(path, key)); !done) return done;
    }
    return {};
}

// Elements are removed and inserted around those that stay, which keep their comments.
Result<void> TomlEditor::merge_lists(const TomlPath& path, const ordered_json& value) {
    if (text_editor_.find(path) == nullptr) {
        const auto plain =
            std::find_if(value.begin(), value.end(), [](const auto& each) { return !each.is_object(); });
        if (plain != value.end()) return list_element_error(path, *plain);
    }
    const auto matched = match_elements(*at(path), json(value));
    std::vector<std::optional<std::size_t>> new_indices(at(path)->size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (!matched[i]) continue;
        new_indices[*matched[i]] = i;
        if (Result<void> done = write_value(below(path, *matched[i]), value[i]); !done) return done;
    }
    if (Result<void> done = arrange(path, std::move(new_indices)); !done) return done;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (matched[i]) continue;
        if (Result<void> done = insert(path, i, value[i]); !done) return done;
    }
    return {};
}

// Sorts the elements of a list by their new indices and removes those without one.
Result<void> TomlEditor::arrange(const TomlPath& list, std::vector<std::optional<std::size_t>> new_indices) {
    const bool keeps_any =
        std::any_of(new_indices.begin(), new_indices.end(), [](const auto& each) { return each; });
    for (std::size_t i = new_indices.size(); i-- > 0;) {
        if (new_indices[i]) continue;
        if (Result<void> done = remove_value(below(list, i)); !done) return done;
        new_indices.erase(new_indices.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const json* const kept = at(list);
    if (keeps_any && (kept == nullptr || kept->size() != new_indices.size())) return Unexpected(kCannotEdit);
    for (auto iterator = new_indices.begin(); !std::is_sorted(iterator, new_indices.end()); ++iterator) {
        const auto next = std::min_element(iterator, new_indices.end());
        shift(list, static_cast<std::size_t>(next - new_indices.begin()),
              static_cast<std::size_t>(iterator - new_indices.begin()));
        std::rotate(iterator, next, next + 1);
    }
    return {};
}

Result<void> TomlEditor::insert(const TomlPath& list, std::size_t index, const ordered_json& value) {
    if (at(list) == nullptr) return Unexpected(kCannotEdit);
    const std::size_t size = at(list)->size();
    if (text_editor_.find(list) == nullptr || index == size) {
        Result<void> done = make_element(list, size, value);
        if (done) shift(list, size, index);
        return done;
    }
    text_editor_.add_element(list, index, value);
    json& json_node = *at(list);
    json_node.insert(json_node.begin() + static_cast<std::ptrdiff_t>(index), json(value));
    return {};
}

void TomlEditor::shift(const TomlPath& list, std::size_t from, std::size_t to) {
    if (from == to) return;
    text_editor_.move(list, from, to);
    json& elements = *at(list);
    json moved = elements[from];
    elements.erase(from);
    elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
}

// The path uses existing tables and lists as far as it can.
Result<void> TomlEditor::make(const TomlPath& path, const ordered_json& value) {
    TomlPath outer = path;
    while (at(outer) == nullptr) outer.pop_back();
    const json& json_node = *at(outer);
    const TomlStep& step = path[outer.size()];
    const auto inner = wrap_in_tables(path, outer.size() + 1, value);
    if (!inner)
        return Unexpected(fmt::format("'{}' cannot be created: the first index of a new list must be 0",
                                      display_text(path)));
    if (const auto* index = std::get_if<std::size_t>(&step)) {
        if (!json_node.is_array())
            return Unexpected(fmt::format("'{}' is {}, and has no elements", display_text(outer),
                                          value_type_text(json_node)));
        return make_element(outer, *index, *inner);
    }
    const auto& key = std::get<std::string>(step);
    if (!json_node.is_object()) {
        return Unexpected(fmt::format("'{}' is {}, and has no key '{}'", display_text(outer),
                                      value_type_text(json_node), key));
    }
    text_editor_.add_key(outer, key, *inner);
    (*at(outer))[key] = *inner;
    return {};
}

Result<void> TomlEditor::make_element(const TomlPath& list, std::size_t index, const ordered_json& value) {
    json& json_node = *at(list);
    if (index > json_node.size()) {
        return Unexpected(fmt::format("'{}' has {} elements; the next index is {}", display_text(list),
                                      json_node.size(), json_node.size()));
    }
    if (text_editor_.find(list) != nullptr) {
        text_editor_.add_element(list, index, value);
    } else if (value.is_object()) {
        text_editor_.add_entry(list, value);
    } else {
        return list_element_error(list, value);
    }
    json_node.push_back(json(value));
    return {};
}

Result<void> TomlEditor::add(const TomlPath& list, const ordered_json& value) {
    if (const auto error = find_path_error(list)) return Unexpected(*error);
    if (const auto error = find_value_error(value)) return Unexpected(*error);
    const json* const json_node = at(list);
    if (json_node != nullptr && !json_node->is_array())
        return Unexpected(
            fmt::format("'{}' is {}, and has no elements", display_text(list), value_type_text(*json_node)));
    return apply_atomically(
        [&] { return make(below(list, json_node == nullptr ? 0 : json_node->size()), value); });
}

Result<void> TomlEditor::remove(const TomlPath& path) {
    if (path.empty()) return Unexpected("the document itself cannot be removed");
    if (at(path) == nullptr)
        return Unexpected(fmt::format("'{}' does not exist and cannot be removed", display_text(path)));
    return apply_atomically([&] { return remove_value(path); });
}

// Tables that the text no longer makes are removed, too.
Result<void> TomlEditor::remove_value(const TomlPath& path) {
    text_editor_.remove(path);
    TomlPath removed = path;
    do {
        json& outer = *at(path_prefix(removed));
        if (const auto* index = std::get_if<std::size_t>(&removed.back())) {
            outer.erase(*index);
        } else {
            outer.erase(std::get<std::string>(removed.back()));
        }
        removed.pop_back();
    } while (!removed.empty() && at(removed)->empty() && !text_editor_.defines(removed));
    return {};
}

Result<void> TomlEditor::move(const TomlPath& path, std::size_t to) {
    const json* const value = at(path);
    if (path.empty() || value == nullptr)
        return Unexpected(fmt::format("'{}' does not exist and cannot be moved", display_text(path)));
    const auto* const from = std::get_if<std::size_t>(&path.back());
    if (from == nullptr)
        return Unexpected(fmt::format("'{}' is not an element of a list", display_text(path)));
    const TomlPath list = path_prefix(path);
    const std::size_t size = at(list)->size();
    if (to >= size)
        return Unexpected(fmt::format("'{}' has {} elements, from 0 on; index {} does not exist",
                                      display_text(list), size, to));
    if (to == *from) return {};
    return apply_atomically([&]() -> Result<void> {
        shift(list, *from, to);
        return {};
    });
}

}  // namespace gsim::base
