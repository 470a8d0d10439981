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

/// Where a machine is to stand: by its axes, or by the tip of its tool. Values of axes are as programs give
/// them, mm and deg, one for each axis; points and directions are in the work frame.
struct PoseChoice {
    std::optional<std::vector<double>> joints = {};
    std::optional<std::array<double, 3>> tip_mm = {};
    /// With a tip, one of these, or neither: then the tool stands as it does at `near`.
    std::optional<std::array<double, 3>> tool_axis = {};  ///< From the tip to the spindle, of any length; the
                                                          ///< turn about it is the least from `near`.
    std::optional<std::array<double, 3>> rpy_deg = {};    ///< Roll about Z, pitch about Y, yaw about X.
    /// Where several ways of the axes lead to the tip, they are told from here; left out: `joints`, or home.
    /// Axes of groups that the inverse leaves alone stay here.
    std::optional<std::vector<double>> near = {};
    /// How far the tip is from the tool centre point, against the tool's axis; below 0 where Z of the tool's
    /// frame looks out of the tool, as with arms.
    double tool_mm = 0;
};

/// How it stands there.
struct Pose {
    std::vector<double> joints = {};
    std::array<double, 3> tip_mm = {};
    std::array<double, 3> tool_axis = {};  ///< Z of the tool's frame, of length 1.
    std::array<double, 3> rpy_deg = {};
    /// All values of the axes that are known to lead there: those within the ranges first, and of them the
    /// nearest first. The machine's own where it has no inverse.
    std::vector<std::vector<double>> solutions = {};
    std::vector<int> beyond = {};  ///< For each axis -1, 0 or 1: below, within, above its range.
    /// Names of bodies that touch each other; none where Machine::read_bodies() has read none.
    std::vector<std::pair<std::string, std::string>> collisions = {};
};

/// Works out a pose. Ranges are no bounds of it. "unreachable": the tip cannot be there so, or the machine
/// has no inverse; "usage": what is asked for does not go together.
GSIM_API tl::expected<Pose, Failure> pose_of(const Machine& machine, const PoseChoice& choice);

}  // namespace gsim::engine
