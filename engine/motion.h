#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "engine/api.h"

namespace gsim::motion {
struct Segment;
}
namespace gsim::machine {
struct Machine;
}

namespace gsim::engine {

/// The max number of axes of a machine.
inline constexpr std::size_t kMaxAxes = 16;
/// A value for each axis of the machine, in the order of Run::axes(): mm, or deg of rotary ones. Values past
/// the last axis are 0.
using AxisValues = std::array<double, kMaxAxes>;

/// An axis of the machine.
struct Axis {
    char letter = 'X';
    bool rotary = false;
};

enum class MoveKind : std::uint8_t {
#define GSIM_MOVE_KIND(name, number, constant) name = (number),
#include "base/kinds/move_kind.def"
};

/// A circle or helix of the tool, about `axis` by the right hand.
struct Arc {
    std::array<double, 3> center_mm = {};  ///< X, Y, Z in machine coordinates.
    std::array<double, 3> axis = {};       ///< Axis of unit length.
    double radius_mm = 0;                  ///< At the start.
    double sweep_rad = 0;                  ///< More than 2 pi for several turns.
};

/// An executed move of the program.
struct Move {
    std::uint64_t n = 0;  ///< Number of the move, from 1.
    MoveKind kind = MoveKind::rapid;
    bool process_on = false;     ///< The process (jet, plasma, laser, spindle) was on.
    bool circular = false;       ///< `arc` says how.
    std::string_view file = {};  ///< Valid in the call alone.
    std::uint32_t line = 0;      ///< From 1; 0: not known.
    double start_s = 0;
    double end_s = 0;
    double length_mm = 0;     ///< Length of the tool's path.
    double feed_per_min = 0;  ///< As programmed, mm/min or deg/min; 0 in rapids and dwells.
    double deviation_mm = 0;  ///< Distance of the tool from its corners if they are rounded.
    AxisValues end = {};
    Arc arc = {};
};

enum class SegmentKind : std::uint8_t {
#define GSIM_SEGMENT_KIND(name, number, constant) name = (number),
#include "base/kinds/segment_kind.def"
};

/// A finished part of motion: a path and a law of time in closed form. Valid in the call alone.
class GSIM_API Segment {
  public:
    Segment(const motion::Segment& exact, const machine::Machine& machine, std::uint32_t line_number,
            bool on);

    SegmentKind kind = SegmentKind::rest;
    bool process_on = false;
    std::uint32_t line = 0;
    double start_s = 0;
    double duration_s = 0;
    double length_mm = 0;  ///< Length of the tool's path.
    AxisValues start = {};
    AxisValues end = {};

    /// Returns axis values; `t_s` counts from the segment's start. Both are exact.
    AxisValues axes_at(double t_s) const;
    double speed_mm_s(double t_s) const;
    /// Returns the largest axis speed as a share of the axis limit (max_speed of the machine file); 0 if no
    /// axis has a limit. Exact on straight paths, on others the largest of nine instants of each smooth part.
    double peak_axis_speed_share() const;

  private:
    const motion::Segment* exact_;
    const machine::Machine* machine_;
};

/// An instant of the run.
struct Sample {
    double t_s = 0;
    double speed_mm_s = 0;  ///< Speed of the tool along its path.
    std::uint32_t line = 0;
    AxisValues axes = {};
};

/// Receive the results of a run since the last call, in the order of time: moves and segments when they
/// become final, so that at most a chunk is held.
using MovesHandler = std::function<void(std::span<const Move>)>;
using SegmentsHandler = std::function<void(std::span<const Segment>)>;
using SamplesHandler = std::function<void(std::span<const Sample>)>;

}  // namespace gsim::engine
