#pragma once

#include <string>
#include <variant>
#include <vector>

#include "base/text/json.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// Values one of which is taken.
struct Choices {
    std::vector<nlohmann::json> values;
};
/// Numbers that are all alike between two.
struct Uniform {
    double from = 0, to = 0;
};
struct Normal {
    double mean = 0, deviation = 0;
};
/// From `from` to `to`, most often `mode`.
struct Triangular {
    double from = 0, to = 0, mode = 0;
};

/// An order of so many things: a list of 0 to count - 1, each once.
struct Order {
    std::size_t count = 0;  ///< kMostOrdered at most.
};
inline constexpr std::size_t kMostOrdered = 18;  ///< Whose orders a double can number.

/// What a setting may be.
using Domain = std::variant<Choices, Uniform, Normal, Triangular, Order>;

/// Something that differs from run to run (SettingValue).
struct Setting {
    std::vector<std::string> keys;  ///< One at least, which get the same values.
    Domain domain;
    SettingUse use = SettingUse::set;
};

/// Adds a value of the setting, for each of its keys.
void add_values(const Setting& setting, const nlohmann::json& value, std::vector<SettingValue>& values);

/// The value that a share of all others lies below: 0 <= share < 1. Choices are alike.
nlohmann::json value_at(const Domain& domain, double share);

}  // namespace gsim::batch
