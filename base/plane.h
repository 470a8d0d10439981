#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gsim {

/// A main plane of X, Y and Z. It is named by its two directions in the order in which arcs turn
/// counter-clockwise, seen against +Z, +Y and +X (G17, G18, G19).
enum class Plane : std::uint8_t { xy, zx, yz };

/// Indices among X, Y and Z (0 to 2) of the two directions of a plane, and of its normal.
struct PlaneAxes {
    int first, second, normal;
};

constexpr PlaneAxes plane_axes(Plane plane) {
    constexpr std::array<PlaneAxes, 3> kAxes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    return kAxes[static_cast<std::size_t>(plane)];
}

constexpr std::string_view name(Plane plane) {
    constexpr std::array<std::string_view, 3> kNames{"xy", "zx", "yz"};
    return kNames[static_cast<std::size_t>(plane)];
}

}  // namespace gsim
