#pragma once

// For machine_file.cpp alone: toml++ is slow to compile and belongs into one translation unit.

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
#include <fmt/ranges.h>

// What toml++ asserts does not hold for some broken files, which it then goes on to report; in a release
// build it would have the compiler rely on it.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_cast<void>(0)
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "runtime/machine/nearest_name.h"

namespace gsim::machine {

/// Keeps the first error of a file, as "file:line:column: sentence". Reading goes on with fall-back values,
/// and whoever started it looks here at the end.
class FirstError {
  public:
    explicit FirstError(std::string_view file_name) : file_name_(file_name) {}

    void report(const toml::source_position& where, std::string_view sentence) {
        if (text_) return;
        text_ = fmt::format("{}:{}:{}: {}", file_name_, std::max<unsigned>(1, where.line),
                            std::max<unsigned>(1, where.column), sentence);
    }

    const std::optional<std::string>& text() const { return text_; }

  private:
    std::string_view file_name_;
    std::optional<std::string> text_;
};

/// What a number may be.
enum class NumberRule { finite, any, positive };

/// One table of the file with the keys that it may hold.
class TomlSection {
  public:
    TomlSection(FirstError& error, const toml::table& table, std::string title,
                std::span<const std::string_view> known_keys)
        : error_(error), table_(table), title_(std::move(title)) {
        for (const auto& [key, value] : table) check_known(key, known_keys);
    }

    const std::string& title() const { return title_; }
    bool has(std::string_view key) const { return table_.contains(key); }
    /// The position of the value of `key`, or of the section where it has no such key.
    toml::source_position where(std::string_view key) const {
        const toml::node* node = table_.get(key);
        return node ? node->source().begin : table_.source().begin;
    }
    void fail(std::string_view key, std::string_view sentence) { error_.report(where(key), sentence); }

    /// The value of `key`, or null; it is an error if there is none.
    const toml::node* require(std::string_view key) {
        const toml::node* node = table_.get(key);
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
        const toml::node* node = table_.get(key);
        if (!node) return fallback;
        if (!node->is_number()) {
            fail_type(key, "a number", *node);
            return fallback;
        }
        const double value = *node->value<double>();
        if (const auto fault = find_fault(value, rule)) {
            fail(key, fmt::format("'{}' must be {}; it is {}", key, *fault, value));
            return fallback;
        }
        return value;
    }

    /// The table under `key`, or null where there is none.
    const toml::table* table(std::string_view key) {
        const toml::node* node = table_.get(key);
        if (!node) return nullptr;
        if (!node->is_table()) fail_type(key, "a table", *node);
        return node->as_table();
    }

    /// The tables of the array under `key`.
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
                              fmt::format("'{}' must hold tables only, each under [[{}]]", key, key));
            } else {
                found.push_back(element.as_table());
            }
        }
        return found;
    }

  private:
    static constexpr double kGreatest = 1e9;  // mm or deg; far beyond any machine, far from overflow

    static std::optional<std::string> find_fault(double value, NumberRule rule) {
        if (std::isnan(value)) return "a number";
        if (std::isinf(value)) {
            if (rule == NumberRule::finite) return "finite";
        } else if (std::abs(value) > kGreatest) {
            return "between -1e9 and 1e9";
        }
        if (rule == NumberRule::positive && value <= 0) return "greater than 0";
        return std::nullopt;
    }

    void check_known(const toml::key& key, std::span<const std::string_view> known_keys) {
        const std::string_view name = key.str();
        if (std::find(known_keys.begin(), known_keys.end(), name) != known_keys.end()) return;
        const auto nearest = nearest_name(name, known_keys);
        const std::string hint = nearest ? fmt::format("did you mean '{}'?", *nearest)
                                         : fmt::format("it may hold: {}", fmt::join(known_keys, ", "));
        error_.report(key.source().begin, fmt::format("unknown key '{}' in {}; {}", name, title_, hint));
    }

    void fail_type(std::string_view key, std::string_view wanted, const toml::node& node) {
        fail(key, fmt::format("'{}' must be {}, not {}", key, wanted, type_name(node.type())));
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

}  // namespace gsim::machine
