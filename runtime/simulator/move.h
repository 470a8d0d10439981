#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/plane.h"
#include "motion/planner/override_schedule.h"

namespace gsim::simulation {

enum class MoveKind : std::uint8_t {
#define GSIM_MOVE_KIND(name, number, constant) name = (number),
#include "base/kinds/move_kind.def"
};

std::string_view name(MoveKind kind);
/// Returns the normal of a main plane about which arcs are counter-clockwise: +Z of xy, +Y of zx, +X of yz.
Eigen::Vector3d plane_normal(Plane plane);
/// Returns the main plane that has this unit vector as its normal, in either direction; no value for an
/// oblique plane.
std::optional<Plane> main_plane(const Eigen::Vector3d& normal);
/// Returns the one of a plane's two normals that is reported: its largest component is above 0. A plane that
/// is a main plane within rounding gets the exact normal of that one. `axis` is of unit length.
Eigen::Vector3d canonical_normal(const Eigen::Vector3d& axis);

/// Source location: index into the simulator's table of file names, and the line, from 1 (0: unknown).
struct SourceLocation {
    std::uint32_t file = 0;
    std::uint32_t line = 0;
};

/// Data of the client for a move in addition to its trajectory; waits in order for the segment with this
/// target id.
struct MoveInfo {
    std::int64_t target_id = 0;
    MoveKind kind = MoveKind::rapid;
    Eigen::Vector3d normal =
        Eigen::Vector3d::UnitZ();  ///< Arc normal: unit, canonical_normal(), of X, Y and Z.
    int turns = 0;                 ///< Turns of an arc: 1 up to a full circle, 2 for one more turn, ...
    SourceLocation location = {};
    double feed_per_min = 0;  ///< mm/min or deg/min; no meaning in a rapid or a dwell.
    bool timed = false;       ///< A time is programmed for the move (inverse time feed), no speed.
    bool process_on = false;
    bool senses_cell = false;    ///< A probe that the bodies of the cell end.
    std::uint32_t switches = 0;  ///< Number of switches of the process by the program so far, on or off.
    std::uint16_t offset = 0;    ///< Active work offset, as WorkOffsets counts them.
    std::uint16_t tcp = 0;       ///< TCP of the tool in use, an index of ToolOffset::tcps_mm().
    motion::EnabledOverrides enabled_overrides = {};  ///< Active operator's overrides.
    bool follows_spindle = false;                     ///< Its feed is given by turns of the spindle.
    std::uint16_t program = 0;       ///< That it is of, as ProgramCalls counts them; 0: the main one.
    std::uint16_t out_of_range = 0;  ///< Bit for each joint that it moves past its range, from the lowest on.
};

/// Sets the normal and the sense of an arc that runs about `axis`, of any length above 0, by the right-hand
/// rule.
void set_axis(MoveInfo& info, const Eigen::Vector3d& axis);
/// Sets the same for an arc through three points. Normal and sense of collinear points have no meaning.
void set_axis(MoveInfo& info, const Eigen::Vector3d& start, const Eigen::Vector3d& via,
              const Eigen::Vector3d& end);

}  // namespace gsim::simulation
