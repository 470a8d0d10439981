#pragma once

// Only for readers of TOML files, because toml++ is slow to compile. Its parser is in toml_section.cpp.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"
#include "base/toml/renamed_keys.h"
#include "base/toml/toml_library.h"

namespace gsim::base {

/// Store of the first error of a file, as "file:line:column: message", and of those at other positions.
/// Reading continues with fall-back values; the caller checks this object at the end.
class FirstError {
  public:
    explicit FirstError(std::string_view file_name) : file_name_(file_name) {}

    void report(const toml::source_position& where, std::string_view message) {
        const std::string location = locate(where);
        // A second error at a position is a consequence of the first.
        const auto is_known = [&](const std::string& text) { return text.starts_with(location); };
        if (!std::any_of(all_.begin(), all_.end(), is_known)) keep(location + in_one_line(message));
    }

    /// Adds a message about content that is read, but that a later version will reject.
    void warn(const toml::source_position& where, std::string_view message) {
        warnings_.push_back(locate(where) + in_one_line(message));
    }

    /// Adds the error of another file, which contains its own source location.
    void adopt(std::string text) { keep(std::move(text)); }
    void adopt_warning(std::string text) { warnings_.push_back(std::move(text)); }

    const std::optional<std::string>& text() const { return first_; }
    /// Returns one error for each position, the first one first.
    const std::vector<std::string>& all() const { return all_; }
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    static constexpr std::size_t kMaxErrors = 100;

    std::string locate(const toml::source_position& where) const {
        return fmt::format("{}:{}:{}: ", file_name_, std::max<unsigned>(1, where.line),
                           std::max<unsigned>(1, where.column));
    }

    void keep(std::string text) {
        if (!first_) first_ = text;
        if (all_.size() < kMaxErrors) all_.push_back(std::move(text));
    }

    // Text quoted from a file may contain line breaks.
    static std::string in_one_line(std::string_view message) {
        std::string line(message);
        std::replace_if(
            line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
        return line;
    }

    std::string_view file_name_;
    std::optional<std::string> first_;
    std::vector<std::string> all_;
    std::vector<std::string> warnings_;
};

/// Returns the tables of a file; if it is not TOML, none and an error.
toml::table parse_toml(FirstError& error, std::string_view toml_text);

/// Permitted range of a number.
enum class NumberRule {
    finite,
    any,
    positive,      ///< Or infinite.
    not_negative,  ///< And finite.
    step,          ///< 0 (none), or large enough that its multiples stay within bounds.
    share,         ///< Share: greater than 0, and at most 1.
    part,          ///< Share that must not be complete: from 0 to below 1.
    percent,       ///< Greater than 0, and at most 100.
    count,         ///< An integer number of objects to keep in memory.
};

/// One table of the file with its permitted keys. A key may also have its name of before
/// (renamed_keys.h).
class TomlSection {
  public:
    TomlSection(FirstError& error, const toml::table& table, std::string title,
                std::span<const std::string_view> known_keys)
        : error_(error), table_(table), title_(std::move(title)) {
        for (const auto& [key, value] : table) check_known(key, known_keys);
    }

    const std::string& title() const { return title_; }
    /// Returns the value of `key`, or null if the section does not have it.
    const toml::node* find(std::string_view key) const {
        if (const toml::node* node = table_.get(key)) return node;
        const auto old_name = old_key_name(title_, key);
        return old_name ? table_.get(*old_name) : nullptr;
    }
    bool has(std::string_view key) const { return find(key) != nullptr; }
    /// Returns the position of the value of `key`, or of the section if it has no such key.
    toml::source_position where(std::string_view key) const {
        const toml::node* node = find(key);
        return node ? node->source().begin : table_.source().begin;
    }
    void fail(std::string_view key, std::string_view message) { error_.report(where(key), message); }
    /// Adds the error of a file that this section names.
    void add_file_error(std::string text) { error_.adopt(std::move(text)); }
    void add_file_warning(std::string text) { error_.adopt_warning(std::move(text)); }

    /// Returns the value of `key`, or null; a missing key is an error.
    const toml::node* require(std::string_view key) {
        const toml::node* node = find(key);
        if (!node) fail(key, fmt::format("{} lacks the key '{}'", title_, key));
        return node;
    }

    std::string text(std::string_view key) {
        const toml::node* node = require(key);
        if (!node) return {};
        if (const auto* value = node->as_string()) return value->get();
        fail_type(key, "a string", *node);
        return {};
    }

    double number(std::string_view key, double fallback, NumberRule rule) {
        const toml::node* node = find(key);
        if (!node) return fallback;
        if (!node->is_number()) {
            fail_type(key, "a number", *node);
            return fallback;
        }
        const double value = *node->value<double>();
        if (const auto error = find_error(value, rule)) {
            fail(key, fmt::format("'{}' must be {}, not {}", key, *error, value));
            return fallback;
        }
        return value;
    }

    bool flag(std::string_view key, bool fallback) {
        const toml::node* node = find(key);
        if (!node) return fallback;
        if (const auto* value = node->as_boolean()) return value->get();
        fail_type(key, "true or false", *node);
        return fallback;
    }

    /// Returns the index in `names` of the value under `key`.
    std::size_t choice(std::string_view key, std::size_t fallback, std::span<const std::string_view> names) {
        const toml::node* node = find(key);
        if (!node) return fallback;
        const auto value = node->value<std::string_view>();
        const auto found = value ? std::find(names.begin(), names.end(), *value) : names.end();
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
        fail(key, fmt::format("'{}' must be \"{}\" or \"{}\"", key,
                              text::joined(names.first(names.size() - 1), "\", \""), names.back()));
        return fallback;
    }

    /// Returns the table under `key`, or null if it does not exist.
    const toml::table* table(std::string_view key) {
        const toml::node* node = find(key);
        if (!node) return nullptr;
        if (!node->is_table()) fail_type(key, "a table", *node);
        return node->as_table();
    }

    /// Returns the table under `key` as a separate section, if it exists.
    std::optional<TomlSection> section(std::string_view key, std::string title,
                                       std::span<const std::string_view> known_keys) {
        const toml::table* inner = table(key);
        if (inner == nullptr) return std::nullopt;
        return TomlSection(error_, *inner, std::move(title), known_keys);
    }

    /// Returns the tables of the array under `key`.
    std::vector<const toml::table*> tables(std::string_view key) {
        std::vector<const toml::table*> found;
        const toml::node* node = require(key);
        if (!node) return found;
        const toml::array* array = node->as_array();
        if (!array) {
            fail_type(key, fmt::format("an array of tables, each under [[{}]]", key), *node);
            return found;
        }
        for (const toml::node& element : *array) {
            if (!element.is_table()) {
                error_.report(element.source().begin,
                              fmt::format("'{}' must contain only tables, each under [[{}]]", key, key));
            } else {
                found.push_back(element.as_table());
            }
        }
        return found;
    }

  private:
    static std::optional<std::string_view> find_error(double value, NumberRule rule);

    void check_known(const toml::key& key, std::span<const std::string_view> known_keys) {
        const std::string_view name = key.str();
        if (std::find(known_keys.begin(), known_keys.end(), name) != known_keys.end()) return;
        if (const auto new_name = renamed_key(title_, name)) return check_renamed(key, *new_name);
        const auto nearest = text::nearest_name(name, known_keys);
        const std::string hint = nearest ? fmt::format("did you mean '{}'?", *nearest)
                                         : fmt::format("known keys: {}", text::joined(known_keys, ", "));
        error_.report(key.source().begin, fmt::format("unknown key '{}' in {}; {}", name, title_, hint));
    }

    void check_renamed(const toml::key& key, std::string_view new_name) {
        if (table_.contains(new_name)) {
            error_.report(key.source().begin, fmt::format("'{}' is the old name of '{}', which {} also has",
                                                          key.str(), new_name, title_));
        } else {
            error_.warn(key.source().begin, deprecated_key_text(key.str(), new_name));
        }
    }

    void fail_type(std::string_view key, std::string_view expected_type, const toml::node& node) {
        fail(key, fmt::format("'{}' must be {}, not {}", key, expected_type, type_name(node.type())));
    }

    static std::string_view type_name(toml::node_type type) {
        switch (type) {
            case toml::node_type::table: return "a table";
            case toml::node_type::array: return "an array";
            case toml::node_type::string: return "a string";
            case toml::node_type::integer:
            case toml::node_type::floating_point: return "a number";
            case toml::node_type::boolean: return "true or false";
            default: return "a date or time";
        }
    }

    FirstError& error_;
    const toml::table& table_;
    std::string title_;
};

}  // namespace gsim::base
