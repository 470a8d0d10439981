#include "runtime/simulator/move.h"

#include <Eigen/Geometry>
#include <cmath>

#include "runtime/report/report.h"

namespace gsim::simulation {

namespace {

constexpr double kAxisTolerance = 1e-9;  // rounding error of a unit vector next to an axis

// Returns the axis that a vector lies closest to. If several are equally close, it is the last one, whatever
// the rounding.
Eigen::Index closest_axis(const Eigen::Vector3d& vector) {
    Eigen::Index closest = 2;
    for (Eigen::Index axis = 1; axis >= 0; --axis) {
        if (std::abs(vector[axis]) > std::abs(vector[closest]) + kAxisTolerance) closest = axis;
    }
    return closest;
}

}  // namespace

std::string_view name(MoveKind kind) {
    // clang-format off
    switch (kind) {
#define GSIM_MOVE_KIND(name, number, constant) case MoveKind::name: return #name;
#include "base/kinds/move_kind.def"
    }
    // clang-format on
    return "";
}

std::string_view name(RunStatus status) {
    // clang-format off
    switch (status) {
#define GSIM_RUN_STATUS(name, number, constant) case RunStatus::name: return #name;
#include "base/kinds/run_status.def"
    }
    // clang-format on
    return "";
}

Eigen::Vector3d plane_normal(Plane plane) {
    return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(plane_axes(plane).normal));
}

std::optional<Plane> main_plane(const Eigen::Vector3d& normal) {
    const Eigen::Index axis = closest_axis(normal);
    if (std::abs(std::abs(normal[axis]) - 1) > kAxisTolerance) return std::nullopt;
    for (Eigen::Index other = 0; other < 3; ++other) {
        if (other != axis && std::abs(normal[other]) > kAxisTolerance) return std::nullopt;
    }
    return static_cast<Plane>(2 - axis);
}

Eigen::Vector3d canonical_normal(const Eigen::Vector3d& axis) {
    if (const auto plane = main_plane(axis)) return plane_normal(*plane);
    return axis[closest_axis(axis)] < 0 ? Eigen::Vector3d(-axis) : axis;
}

void set_axis(MoveInfo& info, const Eigen::Vector3d& axis) {
    info.normal = canonical_normal(axis.normalized());
    info.kind = info.normal.dot(axis) < 0 ? MoveKind::arc_cw : MoveKind::arc_ccw;
}

void set_axis(MoveInfo& info, const Eigen::Vector3d& start, const Eigen::Vector3d& via,
              const Eigen::Vector3d& end) {
    set_axis(info, (via - start).cross(end - via));
}

}  // namespace gsim::simulation
