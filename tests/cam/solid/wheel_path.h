#pragma once

// The pockets of the thesis's wheel as its program cuts them.

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

namespace gsim::solid::models {

/// One line or arc of the TCP on the upper side, on which B and C turn in proportion. Its positions are those
/// of the part: the origin is in its middle.
struct WheelStep {
    std::array<double, 2> begin_mm{}, end_mm{};
    std::optional<std::array<double, 2>> center_mm;  ///< Centre of an arc.
    double sweep_rad = 0;                            ///< Above 0 counter-clockwise.
    std::array<double, 2> begin_deg{}, end_deg{};    ///< B and C, with no needless turn of B.

    std::array<double, 2> at(double share) const;
    /// Direction from the TCP up to the nozzle.
    std::array<double, 3> axis(double share) const;
    /// Returns the distance of a position from the line or arc.
    double distance_mm(const std::array<double, 2>& position) const;
};

/// The four pockets, each closed.
std::vector<std::vector<WheelStep>> wheel_pockets(const std::filesystem::path& path_file);

/// Position of the middle of the part in the program.
inline constexpr std::array<double, 3> kWheelMiddle_mm{500, 500, 52};

}  // namespace gsim::solid::models
