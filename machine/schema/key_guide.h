#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::machine {

/// Type of the value of a key.
enum class KeyKind : std::uint8_t { number, text, truth, list, table };

/// Permitted numbers of a key.
struct NumberRange {
    double least = -1e9;
    double greatest = 1e9;
    bool above_least = false;     ///< The least itself is not permitted.
    bool below_greatest = false;  ///< Nor is the greatest.
    bool or_zero = false;         ///< 0 is one of them, too,
    bool or_infinite = false;     ///< or "inf" (and "-inf" if `least` is below 0).
    bool whole = false;
};
inline constexpr NumberRange kFinite{};
inline constexpr NumberRange kAny{.or_infinite = true};
inline constexpr NumberRange kPositive{.least = 0, .above_least = true, .or_infinite = true};
inline constexpr NumberRange kNotNegative{.least = 0};
inline constexpr NumberRange kStep{.least = 1e-6, .or_zero = true};
inline constexpr NumberRange kShare{.least = 0, .greatest = 1, .above_least = true};
inline constexpr NumberRange kPart{.least = 0, .greatest = 1, .below_greatest = true};
inline constexpr NumberRange kPercent{.least = 0, .greatest = 100, .above_least = true};

/// A key that a file may have, for people who fill in forms.
struct GuideKey {
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
struct GuideTable {
    std::vector<std::string> at;  ///< Its keys from the document on: "axis", "frame".
    bool many = false;            ///< [[axis]]: there may be several.
    std::string meaning = {};
    std::vector<GuideKey> keys = {};
    /// Key that has the value `where_value` in the described tables, if others of the name have other keys.
    std::string where_key = {};
    std::string where_value = {};
};

// Functions for rows of the guides.
GuideKey number_key(std::string name, const NumberRange& range, std::string fallback, std::string meaning);
GuideKey text_key(std::string name, std::string fallback, std::string meaning);
GuideKey choice_key(std::string name, std::string fallback, std::vector<std::string> choices,
                    std::string meaning);
GuideKey truth_key(std::string name, bool fallback, std::string meaning);
GuideKey list_key(std::string name, KeyKind elements, std::size_t count, std::string meaning);
GuideKey table_key(std::string name, std::string meaning);
GuideKey required(GuideKey key);

/// Returns "mm/s2" for "max_acceleration_mm_s2"; empty if a key has no unit.
std::string unit_of_key(std::string_view name);

/// Returns the keys of a table that holds a frame.
std::vector<GuideKey> frame_guide();
/// Returns the keys of the table `shape` of a body.
std::vector<GuideKey> form_guide();

/// Returns all tables of a machine file, including those of its controller. Their keys are those that the
/// reader accepts, which a test checks.
std::vector<GuideTable> machine_guide();
/// Returns the tables of a controller file.
std::vector<GuideTable> controller_guide();

}  // namespace gsim::machine
