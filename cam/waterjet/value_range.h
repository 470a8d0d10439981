#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "cam/waterjet/cutting_speed.h"

namespace gsim::waterjet {

/// The allowed range of a value. The ranges are far wider than in practice; they keep the sums finite.
struct ValueRange {
    std::string_view key;
    double min = 0;
    double max = 0;

    /// Returns an error if the value is out of range, or not a number.
    std::optional<Error> find_error(double value) const {
        if (value >= min && value <= max) return std::nullopt;
        return fmt::format("'{}' must be between {} and {}, not {}", key, min, max, value);
    }
};

namespace range {

inline constexpr ValueRange kPressure{"pressure_mpa", 1, 1000};
inline constexpr ValueRange kOrifice{"orifice_mm", 0.01, 10};
inline constexpr ValueRange kMixingTube{"mixing_tube_mm", 0.01, 100};
inline constexpr ValueRange kAbrasive{"abrasive_g_min", 0.01, 1e5};
inline constexpr ValueRange kQuality{"quality", kSeparationQuality, kFinestQuality};
inline constexpr ValueRange kThickness{"thickness_mm", 1e-3, 1e4};
inline constexpr ValueRange kMachinability{"machinability", 1e-3, 1e6};
inline constexpr ValueRange kSpeed{"speed_mm_min", 1e-3, 1e6};
inline constexpr ValueRange kKerf{"kerf_mm", 0.001, 1000};
inline constexpr ValueRange kPierce{"pierce_s", 0, 1e5};

}  // namespace range

}  // namespace gsim::waterjet
