#pragma once

#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

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

/// What a setting may be.
using Domain = std::variant<Choices, Uniform, Normal, Triangular>;

/// Something that differs from run to run (SettingValue).
struct Setting {
    std::string key;
    Domain domain;
    bool is_factor = false;  ///< Values are factors of what the file has.
};

/// The value that a share of all others lies below: 0 <= share < 1. Choices are alike.
nlohmann::json value_at(const Domain& domain, double share);

}  // namespace gsim::batch
