#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/machine.h"

namespace gsim::engine {

/// The requested pose of a machine: by its axes, or by the tip of its tool. Values of axes are as in
/// programs, mm and deg, one for each axis. Points and directions are in the work frame.
struct PoseRequest {
    std::optional<std::vector<double>> joints = {};
    std::optional<std::array<double, 3>> tcp_mm = {};
    /// With a tip, one of these, or neither: then the tool is oriented as at `near`.
    std::optional<std::array<double, 3>> tool_axis =
        {};  ///< From the tip to the spindle, of any length; its rotation is the smallest from `near`.
    std::optional<std::array<double, 3>> rpy_deg = {};  ///< Roll about Z, pitch about Y, yaw about X.
    /// Selects one of several solutions of the axes for the tip; if missing: `joints`, or home. Axes of
    /// groups that the inverse does not change keep these values.
    std::optional<std::vector<double>> near = {};
    /// Distance of the tip from the tool centre point, against the tool's axis; below 0 if Z of the tool's
    /// frame points out of the tool, as with arms.
    double tool_mm = 0;
};

/// The resulting pose.
struct Pose {
    std::vector<double> joints = {};
    std::array<double, 3> tcp_mm = {};
    std::array<double, 3> tool_axis = {};  ///< Z of the tool's frame, of length 1.
    std::array<double, 3> rpy_deg = {};
    /// All known values of the axes for it: those within the ranges first, and the nearest first among them.
    /// Without an inverse, the machine's own values.
    std::vector<std::vector<double>> solutions = {};
    std::vector<int> out_of_range = {};  ///< For each axis -1, 0 or 1: below, within, above its range.
    /// Names of bodies that touch each other; none if Machine::read_bodies() has read none.
    std::vector<std::pair<std::string, std::string>> collisions = {};
};

/// Computes a pose. Ranges do not limit it. "unreachable": the tip cannot reach it, or the machine has no
/// inverse; "usage": a conflict in the request.
GSIM_API tl::expected<Pose, Error> solve_pose(const Machine& machine, const PoseRequest& pose_request);

}  // namespace gsim::engine
