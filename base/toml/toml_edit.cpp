#include "base/toml/toml_edit.h"

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

constexpr const char* kNotSo = "this change cannot be made in the text as it is written";

tl::unexpected<std::string> fault(std::string sentence) {
    return tl::unexpected(std::move(sentence));
}

std::string_view kind_of(const json& value) {
    if (value.is_object()) return "a table";
    if (value.is_array()) return "a list";
    if (value.is_string()) return "a text";
    return value.is_number() ? "a number" : "true or false";
}

tl::unexpected<std::string> no_entry(const TomlPath& list, const json& value) {
    return fault(
        fmt::format("'{}' is a list of tables; {} cannot be one of them", shown(list), kind_of(value)));
}

TomlPath without_last(const TomlPath& path, std::size_t steps = 1) {
    return {path.begin(), path.end() - static_cast<std::ptrdiff_t>(steps)};
}

std::optional<std::string> find_path_fault(const TomlPath& path) {
    if (path.size() <= kMaxTomlBrackets) return std::nullopt;
    return fmt::format("a path leads through {} tables and lists at most", kMaxTomlBrackets);
}

/// Returns the value inside the tables and lists of the path from step `first` on; nothing if a list would
/// need elements before it.
std::optional<ordered_json> wrapped(const TomlPath& path, std::size_t first, ordered_json value) {
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

tl::expected<TomlEdit, std::string> TomlEdit::read(std::string toml_text, std::string_view file_name) {
    auto value = toml_json(toml_text, file_name);
    if (!value) return tl::unexpected(value.error());
    return TomlEdit(TomlSheet(std::move(toml_text)), *std::move(value));
}

const json* TomlEdit::at(const TomlPath& path) const {
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

json* TomlEdit::at(const TomlPath& path) {
    return const_cast<json*>(std::as_const(*this).at(path));
}

// A change is made completely or not at all, and the text then has the intended meaning.
template <typename Change>
TomlEdit::Done TomlEdit::whole(const Change& change) {
    TomlEdit before = *this;
    Done done = change();
    if (done) {
        auto read = toml_json(text(), "the changed text");
        if (read && *read == value_) {
            value_ = *std::move(read);
            return {};
        }
        done = fault(read ? kNotSo : read.error());
    }
    *this = std::move(before);
    return done;
}

TomlEdit::Done TomlEdit::set(const TomlPath& path, const ordered_json& value) {
    if (const auto wrong = find_path_fault(path)) return fault(*wrong);
    if (const auto wrong = find_value_fault(value)) return fault(*wrong);
    if (path.empty() && !value.is_object()) return fault("a document is a table, with keys");
    return whole([&]() -> Done {
        if (Done done = put(path, value); !done) return done;
        const json* const now = at(path);
        if (now != nullptr && *now == json(value)) return {};
        return fault(fmt::format("'{}' is made by its entries; an empty one is removed", shown(path)));
    });
}

TomlEdit::Done TomlEdit::put(const TomlPath& path, const ordered_json& value) {
    const json* const old = at(path);
    if (old == nullptr) return make(path, value);
    if (*old == json(value)) return {};
    if (old->is_object() && value.is_object()) return merge_objects(path, value);
    if (old->is_array() && value.is_array()) return merge_lists(path, value);
    if (sheet_.find(path) == nullptr) {
        return fault(fmt::format("'{}' is {} on lines of its own; {} cannot stand in its place", shown(path),
                                 kind_of(*old), kind_of(value)));
    }
    sheet_.replace(path, value);
    *at(path) = value;
    return {};
}

TomlEdit::Done TomlEdit::merge_objects(const TomlPath& path, const ordered_json& value) {
    std::vector<std::string> gone;
    for (const auto& [key, old] : at(path)->items()) {
        if (!value.contains(key)) gone.push_back(key);
    }
    for (const auto& [key, wanted] : value.items()) {
        if (Done done = put(below(path, key), wanted); !done) return done;
    }
    for (const std::string& key : gone) {
        if (Done done = take(below(path, key)); !done) return done;
    }
    return {};
}

// Elements are removed and inserted around those that stay, which keep their comments.
TomlEdit::Done TomlEdit::merge_lists(const TomlPath& path, const ordered_json& value) {
    if (sheet_.find(path) == nullptr) {
        const auto plain =
            std::find_if(value.begin(), value.end(), [](const auto& each) { return !each.is_object(); });
        if (plain != value.end()) return no_entry(path, *plain);
    }
    const auto matched = match_elements(*at(path), json(value));
    std::vector<std::optional<std::size_t>> places(at(path)->size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (!matched[i]) continue;
        places[*matched[i]] = i;
        if (Done done = put(below(path, *matched[i]), value[i]); !done) return done;
    }
    if (Done done = arrange(path, std::move(places)); !done) return done;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (matched[i]) continue;
        if (Done done = insert(path, i, value[i]); !done) return done;
    }
    return {};
}

// Sorts the elements of a list by their places and removes those without a place.
TomlEdit::Done TomlEdit::arrange(const TomlPath& list, std::vector<std::optional<std::size_t>> places) {
    const bool keeps_any = std::any_of(places.begin(), places.end(), [](const auto& each) { return each; });
    for (std::size_t i = places.size(); i-- > 0;) {
        if (places[i]) continue;
        if (Done done = take(below(list, i)); !done) return done;
        places.erase(places.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const json* const kept = at(list);
    if (keeps_any && (kept == nullptr || kept->size() != places.size())) return fault(kNotSo);
    for (auto place = places.begin(); !std::is_sorted(place, places.end()); ++place) {
        const auto next = std::min_element(place, places.end());
        shift(list, static_cast<std::size_t>(next - places.begin()),
              static_cast<std::size_t>(place - places.begin()));
        std::rotate(place, next, next + 1);
    }
    return {};
}

TomlEdit::Done TomlEdit::insert(const TomlPath& list, std::size_t index, const ordered_json& value) {
    if (at(list) == nullptr) return fault(kNotSo);
    const std::size_t size = at(list)->size();
    if (sheet_.find(list) == nullptr || index == size) {
        Done done = make_element(list, size, value);
        if (done) shift(list, size, index);
        return done;
    }
    sheet_.add_element(list, index, value);
    json& there = *at(list);
    there.insert(there.begin() + static_cast<std::ptrdiff_t>(index), json(value));
    return {};
}

void TomlEdit::shift(const TomlPath& list, std::size_t from, std::size_t to) {
    if (from == to) return;
    sheet_.move(list, from, to);
    json& elements = *at(list);
    json moved = elements[from];
    elements.erase(from);
    elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
}

// The path uses existing tables and lists as far as it can.
TomlEdit::Done TomlEdit::make(const TomlPath& path, const ordered_json& value) {
    TomlPath outer = path;
    while (at(outer) == nullptr) outer.pop_back();
    const json& there = *at(outer);
    const TomlStep& step = path[outer.size()];
    const auto inner = wrapped(path, outer.size() + 1, value);
    if (!inner)
        return fault(fmt::format("'{}' cannot be made: the first element of a new list is 0", shown(path)));
    if (const auto* index = std::get_if<std::size_t>(&step)) {
        if (!there.is_array())
            return fault(fmt::format("'{}' is {}, and has no elements", shown(outer), kind_of(there)));
        return make_element(outer, *index, *inner);
    }
    const auto& key = std::get<std::string>(step);
    if (!there.is_object()) {
        return fault(fmt::format("'{}' is {}, and has no key '{}'", shown(outer), kind_of(there), key));
    }
    sheet_.add_key(outer, key, *inner);
    (*at(outer))[key] = *inner;
    return {};
}

TomlEdit::Done TomlEdit::make_element(const TomlPath& list, std::size_t index, const ordered_json& value) {
    json& there = *at(list);
    if (index > there.size()) {
        return fault(
            fmt::format("'{}' has {} elements; the next one is {}", shown(list), there.size(), there.size()));
    }
    if (sheet_.find(list) != nullptr) {
        sheet_.add_element(list, index, value);
    } else if (value.is_object()) {
        sheet_.add_entry(list, value);
    } else {
        return no_entry(list, value);
    }
    there.push_back(json(value));
    return {};
}

TomlEdit::Done TomlEdit::add(const TomlPath& list, const ordered_json& value) {
    if (const auto wrong = find_path_fault(list)) return fault(*wrong);
    if (const auto wrong = find_value_fault(value)) return fault(*wrong);
    const json* const there = at(list);
    if (there != nullptr && !there->is_array())
        return fault(fmt::format("'{}' is {}, and has no elements", shown(list), kind_of(*there)));
    return whole([&] { return make(below(list, there == nullptr ? 0 : there->size()), value); });
}

TomlEdit::Done TomlEdit::remove(const TomlPath& path) {
    if (path.empty()) return fault("a document itself is not removed");
    if (at(path) == nullptr) return fault(fmt::format("there is no '{}' to remove", shown(path)));
    return whole([&] { return take(path); });
}

// Tables that the text no longer makes are removed, too.
TomlEdit::Done TomlEdit::take(const TomlPath& path) {
    sheet_.remove(path);
    TomlPath gone = path;
    do {
        json& outer = *at(without_last(gone));
        if (const auto* index = std::get_if<std::size_t>(&gone.back())) {
            outer.erase(*index);
        } else {
            outer.erase(std::get<std::string>(gone.back()));
        }
        gone.pop_back();
    } while (!gone.empty() && at(gone)->empty() && !sheet_.makes(gone));
    return {};
}

TomlEdit::Done TomlEdit::move(const TomlPath& path, std::size_t to) {
    const json* const value = at(path);
    if (path.empty() || value == nullptr) return fault(fmt::format("there is no '{}' to move", shown(path)));
    const auto* const from = std::get_if<std::size_t>(&path.back());
    if (from == nullptr) return fault(fmt::format("'{}' is no element of a list", shown(path)));
    const TomlPath list = without_last(path);
    const std::size_t size = at(list)->size();
    if (to >= size)
        return fault(
            fmt::format("'{}' has {} elements, from 0 on; there is no place {}", shown(list), size, to));
    if (to == *from) return {};
    return whole([&]() -> Done {
        shift(list, *from, to);
        return {};
    });
}

}  // namespace gsim::base
