#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::machine {

/// What stands behind a key.
enum class KeyKind : std::uint8_t { number, text, truth, list, table };

/// Which numbers a key takes.
struct NumberRange {
    double least = -1e9;
    double greatest = 1e9;
    bool above_least = false;     ///< The least itself is none of them.
    bool below_greatest = false;  ///< Nor is the greatest.
    bool or_zero = false;         ///< 0 is one of them, too,
    bool or_infinite = false;     ///< or "inf" (and "-inf" where `least` is below 0).
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
    NumberRange range = {};              ///< Of a number, and of the numbers of a list.
    KeyKind elements = KeyKind::number;  ///< Of a list.
    std::size_t count = 0;               ///< How many a list has; 0: any.
    std::string fallback = {};  ///< What holds without the key, as it is written; empty: see `meaning`.
    std::vector<std::string> choices = {};  ///< Of a text.
    bool open = false;                      ///< There are others than these choices.
    bool required = false;
    bool many = false;  ///< `name` is the first of the keys that the meaning tells.
};

/// A table of a file.
struct GuideTable {
    std::vector<std::string> at;  ///< Its keys from the document on: "axis", "frame".
    bool many = false;            ///< [[axis]]: there may be several.
    std::string meaning = {};
    std::vector<GuideKey> keys = {};
    /// The tables of which it tells have this value here, where others of the name have other keys.
    std::string where_key = {};
    std::string where_value = {};
};

// Rows of the guides.
GuideKey number_key(std::string name, const NumberRange& range, std::string fallback, std::string meaning);
GuideKey text_key(std::string name, std::string fallback, std::string meaning);
GuideKey choice_key(std::string name, std::string fallback, std::vector<std::string> choices,
                    std::string meaning);
GuideKey truth_key(std::string name, bool fallback, std::string meaning);
GuideKey list_key(std::string name, KeyKind elements, std::size_t count, std::string meaning);
GuideKey table_key(std::string name, std::string meaning);
GuideKey required(GuideKey key);

/// "mm/s2" of "max_acceleration_mm_s2"; empty where a key has no unit.
std::string unit_of_key(std::string_view name);

/// The keys of a table that holds a frame.
std::vector<GuideKey> frame_guide();
/// The keys of the table `shape` of a body.
std::vector<GuideKey> form_guide();

/// All tables of a machine file, those of its controller among them; their keys are those that the reader
/// takes, which a test holds.
std::vector<GuideTable> machine_guide();
/// Those of a controller file.
std::vector<GuideTable> controller_guide();

}  // namespace gsim::machine
