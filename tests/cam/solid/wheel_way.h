#pragma once

// The pockets of the thesis's wheel as its program cuts them.

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

namespace gsim::solid::models {

/// One line or arc of the tip on the upper side, on which B and C turn in proportion. Its places are those of
/// the part: the origin in its middle.
struct WheelStep {
    std::array<double, 2> begin_mm{}, end_mm{};
    std::optional<std::array<double, 2>> center_mm;  ///< Of an arc.
    double sweep_rad = 0;                            ///< Above 0 counter-clockwise.
    std::array<double, 2> begin_deg{}, end_deg{};    ///< B and C, with no needless turn of B.

    std::array<double, 2> at(double share) const;
    /// From the tip up to the nozzle.
    std::array<double, 3> axis(double share) const;
    /// How far a place is from the line or arc.
    double distance_mm(const std::array<double, 2>& place) const;
};

/// The four pockets, each closed.
std::vector<std::vector<WheelStep>> wheel_pockets(const std::filesystem::path& path_file);

/// Where the middle of the part is in the program.
inline constexpr std::array<double, 3> kWheelMiddle_mm{500, 500, 52};

}  // namespace gsim::solid::models
