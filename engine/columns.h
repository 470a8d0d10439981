#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace gsim::engine {

/// Bits of SegmentColumns::flags, and what stands in the others.
struct SegmentFlags {
    static constexpr std::uint32_t kKind = 3;  ///< SegmentKind.
#define GSIM_SEGMENT_FLAG(name, constant, bit) static constexpr std::uint32_t constant = 1U << bit##U;
#include "base/kinds/segment_flag.def"
    static constexpr std::uint32_t kMoveKindShift = 8;  ///< Four bits: MoveKind.
    static constexpr std::uint32_t kLimitShift = 12;    ///< Four bits: what kept it from being faster.
    static constexpr std::uint32_t kLimitAxisShift =
        16;  ///< Five bits: the axis of that limit plus 1; 0: none.
};

/// Segments of a run as columns, for whoever draws them or works out where the axes are somewhere else: all
/// that a closed form needs is in `values`, in 64 bits. docs/studio.md has the layout of a record.
struct SegmentColumns {
    std::uint64_t first = 0;  ///< Number of the first segment in the run, from 0.
    /// One entry for each segment.
    std::vector<double> start_s, duration_s, length_mm, feed_per_min, deviation_mm;
    std::vector<std::uint32_t> line, file, flags, tip;
    std::vector<std::uint32_t> record;  ///< Where in `values` its record begins.
    std::vector<double> values;
    /// The way of the tool's tip on the part, in the work frame: three coordinates (mm) for each vertex, its
    /// time, and its segment, counted from `first`. The first vertex of all is where the run starts.
    std::vector<float> vertex_mm;
    std::vector<float> vertex_s;
    std::vector<std::uint32_t> vertex_segment;
};

/// Takes what a run has made since the last call, in the order of time.
using TakeColumns = std::function<void(const SegmentColumns&)>;

/// What the motors bring up over time (docs/dynamics.md), at instants that show each curve: the ends of each
/// part in which it is smooth, and so many in between that straight lines are within 0.2 % of the highest so
/// far. Where it jumps there are two at nearly one instant.
struct EffortColumns {
    /// One entry for each instant, in the order of time.
    std::vector<double> t_s;
    std::vector<std::uint32_t> line;
    std::vector<float> power_w;  ///< Of all motors together; below 0 where they are driven.
    /// For each instant one for each axis of the machine: N, or Nm of rotary ones.
    std::vector<float> efforts;
    /// The same for the most that its motor brings up at its speed there; infinite where nothing is told.
    std::vector<float> motor_peaks;
};

/// Takes what a run has made since the last call, in the order of time.
using TakeEfforts = std::function<void(const EffortColumns&)>;

/// Where axes and tip really are over time (docs/servo.md), at the ends of steps of a millisecond at most,
/// and longer ones where nothing changes.
struct FollowingColumns {
    /// One entry for each instant, in the order of time.
    std::vector<double> t_s;
    std::vector<std::uint32_t> line;
    std::vector<float> contour_mm;  ///< Of the tip from the way of its set points; NaN: not known there.
    std::vector<float> tip_mm;      ///< Three for each instant: the real tip on the part.
    /// For each instant one for each axis: set point less place, mm, or deg of rotary ones.
    std::vector<float> errors;
};

/// Takes what a run has made since the last call, in the order of time.
using TakeFollowing = std::function<void(const FollowingColumns&)>;

/// The most segments of a call.
inline constexpr std::uint32_t kColumnChunk = 16'384;

}  // namespace gsim::engine
