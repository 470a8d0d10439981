#include "machine/model/axis_direction.h"

#include <cstddef>

namespace gsim::machine {

namespace {

constexpr int kDirections = 3;

// Returns the index of x, y and z.
Eigen::Index axis_index(AxisDirection direction) {
    return static_cast<Eigen::Index>(direction) % kDirections;
}

bool is_negative(AxisDirection direction) {
    return static_cast<int>(direction) >= kDirections;
}

}  // namespace

std::string_view name(AxisDirection direction) {
    return kDirectionNames[static_cast<std::size_t>(direction)];
}

AxisDirection opposite(AxisDirection direction) {
    return static_cast<AxisDirection>((static_cast<int>(direction) + kDirections) % (2 * kDirections));
}

// Integers throughout, so that values of axes give clean coordinates.
rrs::CartPos rotation_to(AxisDirection direction) {
    rrs::CartPos frame = rrs::CartPos::Identity();
    const Eigen::Index z = axis_index(direction);
    const Eigen::Vector3d along = (is_negative(direction) ? -1 : 1) * Eigen::Vector3d::Unit(z);
    const Eigen::Vector3d perpendicular = Eigen::Vector3d::Unit((z + 1) % kDirections);
    frame.linear().col(0) = perpendicular;
    frame.linear().col(1) = along.cross(perpendicular);
    frame.linear().col(2) = along;
    return frame;
}

}  // namespace gsim::machine
