#pragma once

#include <string>
#include <variant>
#include <vector>

#include "base/text/json.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// Values from which one is taken.
struct Choices {
    std::vector<nlohmann::json> values;
};
/// Uniformly distributed numbers between two bounds.
struct Uniform {
    double from = 0, to = 0;
};
struct Normal {
    double mean = 0, deviation = 0;
};
/// Triangular distribution from `from` to `to` with its peak at `mode`.
struct Triangular {
    double from = 0, to = 0, mode = 0;
};

/// Order of a number of items: a list of 0 to count - 1, each once.
struct Order {
    std::size_t count = 0;  ///< At most kMaxOrdered.
};
inline constexpr std::size_t kMaxOrdered = 18;  ///< Orders of so many fit into a double.

/// Domain of a setting.
using Domain = std::variant<Choices, Uniform, Normal, Triangular, Order>;

/// Quantity that differs from run to run (SettingValue).
struct Setting {
    std::vector<std::string> keys;  ///< At least one; all get the same values.
    Domain domain;
    SettingUse use = SettingUse::set;
};

/// Adds a value of the setting for each of its keys.
void add_values(const Setting& setting, const nlohmann::json& value, std::vector<SettingValue>& values);

/// Returns the quantile: the value that a share of all others lies below, 0 <= share < 1. Choices are equally
/// likely.
nlohmann::json value_at(const Domain& domain, double share);

}  // namespace gsim::batch
