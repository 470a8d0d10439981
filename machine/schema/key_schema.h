#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::machine {

/// Type of the value of a key.
enum class KeyKind : std::uint8_t { number, text, boolean, list, table };

/// Permitted numbers of a key.
struct NumberRange {
    double min = -1e9;
    double max = 1e9;
    bool exclusive_min = false;    ///< The least itself is not permitted.
    bool exclusive_max = false;    ///< Nor is the greatest.
    bool allows_zero = false;      ///< 0 is one of them, too,
    bool allows_infinite = false;  ///< or "inf" (and "-inf" if `min` is below 0).
    bool integer_only = false;
};
inline constexpr NumberRange kFinite{};
inline constexpr NumberRange kAny{.allows_infinite = true};
inline constexpr NumberRange kPositive{.min = 0, .exclusive_min = true, .allows_infinite = true};
inline constexpr NumberRange kNotNegative{.min = 0};
inline constexpr NumberRange kStep{.min = 1e-6, .allows_zero = true};
inline constexpr NumberRange kPositiveFraction{.min = 0, .max = 1, .exclusive_min = true};
inline constexpr NumberRange kFractionBelowOne{.min = 0, .max = 1, .exclusive_max = true};
inline constexpr NumberRange kPercent{.min = 0, .max = 100, .exclusive_min = true};

/// A key that a file may have, for people who fill in forms.
struct KeySchema {
    std::string name;
    KeyKind kind = KeyKind::number;
    std::string meaning = {};
    NumberRange range = {};              ///< For a number, and for the numbers of a list.
    KeyKind elements = KeyKind::number;  ///< Elements of a list.
    std::size_t count = 0;               ///< Length of a list; 0: any.
    std::string fallback = {};           ///< Value without the key, as it is written; empty: see `meaning`.
    std::vector<std::string> choices = {};  ///< For a text.
    bool open = false;                      ///< There are others than these choices.
    bool required = false;
    bool many = false;  ///< `name` is the first of the keys that the meaning lists.
};

/// A table of a file.
struct TableSchema {
    std::vector<std::string> at;  ///< Its keys from the document on: "axis", "frame".
    bool many = false;            ///< [[axis]]: there may be several.
    std::string meaning = {};
    std::vector<KeySchema> keys = {};
    /// Key that has the value `condition_value` in the described tables, if others of the name have other
    /// keys.
    std::string condition_key = {};
    std::string condition_value = {};
};

// Functions for rows of the guides.
KeySchema number_key(std::string name, const NumberRange& range, std::string fallback, std::string meaning);
KeySchema text_key(std::string name, std::string fallback, std::string meaning);
KeySchema choice_key(std::string name, std::string fallback, std::vector<std::string> choices,
                     std::string meaning);
KeySchema flag_key(std::string name, bool fallback, std::string meaning);
KeySchema list_key(std::string name, KeyKind elements, std::size_t count, std::string meaning);
KeySchema table_key(std::string name, std::string meaning);
KeySchema required(KeySchema key);

/// Returns "mm/s2" for "max_acceleration_mm_s2"; empty if a key has no unit.
std::string key_unit(std::string_view name);

/// Returns the keys of a table that holds a frame.
std::vector<KeySchema> frame_schema();
/// Returns the keys of the table `shape` of a body.
std::vector<KeySchema> shape_schema();

/// Returns all tables of a machine file, including those of its controller. Their keys are those that the
/// reader accepts, which a test checks.
std::vector<TableSchema> machine_schema();
/// Returns the tables of a controller file.
std::vector<TableSchema> controller_schema();

}  // namespace gsim::machine
