#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "toolpath/model/arc_shape.h"
#include "toolpath/rotary/machine_approach.h"
#include "toolpath/rotary/rotary_entries.h"

namespace gsim::path {

/// Arc in one of the planes of X, Y and Z; motion along the third axis makes it a helix.
struct AxisArc {
    int about = 2;                  ///< The axis that it turns about: 0 X, 1 Y, 2 Z.
    bool counterclockwise = false;  ///< By the right hand about that axis.
    Vector center_offset_mm{};      ///< From the start, along X, Y and Z.
    double turn_rad = 0;            ///< > 0
    int turns = 1;                  ///< Circles that it begins; one unless MoveOptions::multi_turn_arcs.
    /// X, Y and Z halfway, for an arc in an oblique plane. This point defines the arc; of the above only
    /// turn_rad counts then.
    std::optional<Vector> via_mm = {};
};

/// Treatment of arcs outside the planes of X, Y and Z.
enum class ObliqueArcs { lines, through_points, rejected };

/// One move of the machine's axes.
struct AxisMove {
    AxisValues axes;                        ///< For all axes, mm or deg.
    bool rapid = false;                     ///< Otherwise `feed_per_min` counts.
    std::optional<AxisArc> arc;             ///< Otherwise all axes go in proportion.
    double feed_per_min = 0;                ///< mm/min along X, Y and Z, or deg/min if only rotary axes move.
    bool feed_is_rotary = false;            ///< deg/min
    std::optional<double> duration_s = {};  ///< Source of the feed: time of the complete move.
    std::optional<double> feed_mm_rev = {};  ///< Likewise: distance per turn of the spindle.
    std::optional<double> lead_mm = {};      ///< For a move in step with the spindle: distance per turn.
};

/// Receiver of the moves of a path, in their order.
class MoveSink {
  public:
    virtual ~MoveSink() = default;
    /// Begins a target; what follows belongs to it.
    virtual void begin(const TargetId& /*where*/) {}
    virtual void move(const AxisMove& move) = 0;
    /// Reports the axis values, though no move has led there.
    virtual void set_position(const AxisValues& /*axes*/) {}
    /// Raises the tool to change something: the tool itself, or the reference of positions.
    virtual void retract() {}
    /// Finds the position of the active work coordinate system by a touch of the tool, which is up.
    virtual void touch(const std::string& /*frame*/, const Touch& /*touch*/) {}
    /// Moves some axes to a position of the machine; the others stay.
    virtual void go_to(const MachineApproach& /*way*/) {}
    /// Selects a work coordinate system by its name; axis values of a recorded path stay those of the
    /// machine.
    virtual void work_offset(const std::string& /*name*/) {}
    virtual void dwell(double seconds) = 0;
    /// Sets the acceleration along the path, from the next move on.
    virtual void acceleration(double mm_s2) = 0;
    virtual void action(const std::string& name) = 0;
    virtual void call(const SubPath& sub_path) = 0;
    /// Reports a remark about what follows.
    virtual void note(const TargetId& where, std::string_view message) = 0;
};

struct MoveOptions {
    double tolerance_mm = 0.01;    ///< Max deviation of parts from the path.
    double resolution_mm = 0.001;  ///< Smallest step of a program's numbers.
    ObliqueArcs oblique_arcs = ObliqueArcs::lines;
    bool arcs = true;                        ///< True if arcs may stay arcs.
    bool multi_turn_arcs = false;            ///< True if one may turn by more than a circle.
    ToolChangeStops tool_change_stops = {};  ///< Devices to restart after a tool change.
    /// Positions of work coordinate systems. For those without a position the ranges of X, Y and Z do not
    /// apply.
    std::map<std::string, std::optional<Vector>, std::less<>> frames_mm = {};
    /// Machine coordinate of Z that MoveSink::retract() leads to; nullopt: Z has no upper end.
    std::optional<double> retract_mm = {};
};

/// Converter of the points of a path into moves of the axes. Arcs stay arcs if they lie in a plane of the
/// axes, or if the options allow oblique ones. Otherwise, and if rotary axes move the linear ones as well,
/// motions are cut into lines.
class AxisMoves {
  public:
    /// All arguments must outlive this.
    AxisMoves(const Program& program, const MachineSpace& space, const States& states,
              const std::vector<RotarySchedule>& turns, const MoveOptions& options)
        : program_(program),
          space_(space),
          states_(states),
          turns_(turns),
          options_(options),
          entries_(rotary_entries(program, states, turns)),
          jet_(has_jet(program)) {}

    /// Writes all of one path that the root leads to. Sub-paths are calls.
    tl::expected<void, TargetError> run(std::size_t path, MoveSink& sink) const;

  private:
    const Program& program_;
    const MachineSpace& space_;
    const States& states_;
    const std::vector<RotarySchedule>& turns_;
    MoveOptions options_;
    std::vector<std::optional<AxisValues>> entries_;  // rotary axis values at the start of each path
    bool jet_;
};

}  // namespace gsim::path
