#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

namespace gsim::simulation {

/// `thread`: a feed move in step with the spindle; `spline`: a chord of a curve.
enum class MoveKind : std::uint8_t { rapid, linear, arc_cw, arc_ccw, dwell, probe, thread, spline };
enum class Plane : std::uint8_t { xy, zx, yz };

std::string_view name(MoveKind kind);
std::string_view name(Plane plane);

/// A place in a source: index into the simulator's table of file names, and the line, from 1 (0: unknown).
struct Place {
    std::uint32_t file = 0;
    std::uint32_t line = 0;
};

/// What the client knows of a move besides its trajectory; waits in order for the segment with this target
/// id.
struct MoveInfo {
    std::int64_t target_id = 0;
    MoveKind kind = MoveKind::rapid;
    Plane plane = Plane::xy;
    int turns = 0;  ///< Of an arc: 1 up to a full circle, 2 for one more turn, ...
    Place place = {};
    double feed_per_min = 0;  ///< mm/min or deg/min; no meaning in a rapid or a dwell.
    bool timed = false;       ///< A time is programmed for the move (inverse time feed), no speed.
    bool jet_on = false;
};

/// An arc through three points is told in the main plane that it lies closest to, with its sense there.
void set_plane_and_sense(MoveInfo& info, const Eigen::Vector3d& start, const Eigen::Vector3d& via,
                         const Eigen::Vector3d& end);

}  // namespace gsim::simulation
