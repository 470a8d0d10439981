#pragma once

#include <cstddef>

namespace gsim::rrs {

/// Path along which the speed of a block in the look-ahead window is measured.
enum class PathMeasure {
    tool,      ///< The tool's path; rotary axes move in proportion.
    all_axes,  ///< The norm of all axes' distances, a degree as a millimetre (grbl's planner).
};

/// How the controller processes blocks, and which feed they get.
struct BlockRules {
    /// Number of blocks known ahead, including the current one; the newest of them is planned to end at
    /// standstill.
    std::size_t look_ahead = 100;
    /// Time that the controller needs to prepare a block, so that no move takes less; 0: no time. Only for
    /// planners that apply CornerRules.
    double time_s = 0;
    PathMeasure path_measure = PathMeasure::tool;
    /// Path along which F is measured in a move of rotary axes and of others, if path_measure is all_axes
    /// (grblHAL: $701 = 1 is the tool's path).
    PathMeasure feed_measure = PathMeasure::tool;
    double min_feed_mm_min = 0;  ///< A lower one is raised to it.

    bool operator==(const BlockRules&) const = default;
};

}  // namespace gsim::rrs
