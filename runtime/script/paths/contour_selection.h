#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

/// Data for a script about a closed loop or a chain of edges of a part, in the frame of its file.
struct ContourDescription {
    struct Edge {
        std::string name;  ///< "edge #12 of the plane face #40"
        double length_mm = 0;
    };
    std::string face;  ///< "the plane face #40 at (1, 2, 3)"
    bool is_hole = false;
    bool is_open = false;  ///< A chain.
    double length_mm = 0;
    std::array<double, 3> low_mm{}, high_mm{};  ///< Corners of the box about it.
    std::array<double, 3> normal{};             ///< Mean normal of the face, out of the material.
    double depth_mm = 0;                        ///< Max depth of a wall below it.
    double tilt_deg = 0;                        ///< Max tilt of a wall from the normal.
    std::vector<Edge> edges = {};               ///< In order.
};

/// Runs a script that returns a function, and calls it with a table of each contour. The result of a contour
/// is true if the function returns true, and false for false or nil. It runs in the sandbox, until `cpu`, if
/// given, is used up. The error is "file:line: message".
Result<std::vector<bool>> choose_contours(std::string_view lua, const std::string& file_name,
                                          std::span<const ContourDescription> contours,
                                          const LuaState::Limits& limits = {}, os::CpuLimit* cpu = nullptr);

}  // namespace gsim::script
