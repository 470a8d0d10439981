#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace gsim::engine {

/// Bits of SegmentColumns::flags, and the contents of the others.
struct SegmentFlags {
    static constexpr std::uint32_t kKindMask = 3;  ///< SegmentKind.
#define GSIM_SEGMENT_FLAG(name, constant, bit) static constexpr std::uint32_t constant = 1U << bit##U;
#include "base/kinds/segment_flag.def"
    static constexpr std::uint32_t kMoveKindShift = 8;  ///< Four bits: MoveKind.
    static constexpr std::uint32_t kLimitShift = 12;    ///< Four bits: what kept it from being faster.
    static constexpr std::uint32_t kLimitAxisShift =
        16;  ///< Five bits: the axis of that limit plus 1; 0: none.
};

/// Segments of a run as columns, for programs that draw them or compute the axis positions elsewhere:
/// `values` contains all inputs of a closed form, in 64 bits. docs/studio.md has the layout of a record.
struct SegmentColumns {
    std::uint64_t first = 0;  ///< Number of the first segment in the run, from 0.
    /// One entry for each segment.
    std::vector<double> start_s, duration_s, length_mm, feed_per_min, deviation_mm;
    std::vector<std::uint32_t> line, file, flags, tcp;
    std::vector<std::uint32_t> record;  ///< Start index of its record in `values`.
    std::vector<double> values;
    /// The path of the TCP on the part, in the work frame: three coordinates (mm) for each vertex, its time,
    /// and its segment, counted from `first`. The first vertex of all is the start of the run.
    std::vector<float> vertex_mm;
    std::vector<float> vertex_s;
    std::vector<std::uint32_t> vertex_segment;
};

/// Receives the results of a run since the last call, in the order of time.
using ColumnsHandler = std::function<void(const SegmentColumns&)>;

/// Motor forces and torques over time (docs/dynamics.md), at instants that show each curve: the ends of each
/// smooth part, and so many in between that straight lines are within 0.2 % of the highest value so far. A
/// jump has two instants at nearly one time.
struct EffortColumns {
    /// One entry for each instant, in the order of time.
    std::vector<double> t_s;
    std::vector<std::uint32_t> line;
    std::vector<float> power_w;  ///< Total of all motors; below 0 if they are driven.
    /// For each instant one value for each axis of the machine: N, or Nm of rotary ones.
    std::vector<float> efforts;
    /// The same for the max of its motor at its speed there; infinite if not specified.
    std::vector<float> motor_peaks;
};

/// Receives the results of a run since the last call, in the order of time.
using EffortsHandler = std::function<void(const EffortColumns&)>;

/// Actual positions of axes and TCP over time (docs/servo.md), at the ends of steps of at most a millisecond,
/// and longer ones without changes.
struct FollowingColumns {
    /// One entry for each instant, in the order of time.
    std::vector<double> t_s;
    std::vector<std::uint32_t> line;
    std::vector<float>
        contour_error_mm;       ///< TCP deviation from the path of its set points; NaN: not known there.
    std::vector<float> tcp_mm;  ///< Three for each instant: the actual TCP on the part.
    /// For each instant one value for each axis: set point minus position, mm, or deg of rotary ones.
    std::vector<float> errors;
};

/// Receives the results of a run since the last call, in the order of time.
using FollowingHandler = std::function<void(const FollowingColumns&)>;

/// The max number of segments of a call.
inline constexpr std::uint32_t kColumnChunk = 16'384;

}  // namespace gsim::engine
