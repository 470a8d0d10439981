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
#include "toolpath/rotary/machine_way.h"
#include "toolpath/rotary/rotary_entries.h"

namespace gsim::path {

/// An arc in one of the planes of X, Y and Z; what it moves along the third axis makes it a helix.
struct AxisArc {
    int about = 2;                  ///< The axis that it turns about: 0 X, 1 Y, 2 Z.
    bool counterclockwise = false;  ///< By the right hand about that axis.
    Vector center_offset_mm{};      ///< From the start, along X, Y and Z.
    double turn_rad = 0;            ///< > 0
    int turns = 1;                  ///< Circles that it begins; one unless MoveOptions::arcs_of_turns.
    /// X, Y and Z halfway, of an arc in an oblique plane. That tells the arc; of the above turn_rad alone
    /// counts then.
    std::optional<Vector> via_mm = {};
};

/// What becomes of arcs outside the planes of X, Y and Z.
enum class ObliqueArcs { lines, through_points, refused };

/// One move of the machine's axes.
struct AxisMove {
    AxisValues axes;              ///< Of all axes, mm or deg.
    bool rapid = false;           ///< Otherwise `feed_per_min` counts.
    std::optional<AxisArc> arc;   ///< Otherwise all axes go in proportion.
    double feed_per_min = 0;      ///< mm/min along X, Y and Z, or deg/min where rotary axes alone move.
    bool feed_is_rotary = false;  ///< deg/min
    std::optional<double> duration_s = {};   ///< The feed comes from: how long the whole move takes.
    std::optional<double> feed_mm_rev = {};  ///< Likewise: the way in a turn of the spindle.
    std::optional<double> lead_mm = {};      ///< The move is in step with the spindle: its way in a turn.
};

/// What the moves of a path are told to, in their order.
class MoveSink {
  public:
    virtual ~MoveSink() = default;
    /// What follows is of this target.
    virtual void begin(const TargetId& /*where*/) {}
    virtual void move(const AxisMove& move) = 0;
    /// The axes stand there, though no move has led there.
    virtual void stand(const AxisValues& /*axes*/) {}
    /// The tool goes up, to change something: itself, or what positions are counted in.
    virtual void retract() {}
    /// The tool, which is up, finds by a touch where a work coordinate system lies, which is in force.
    virtual void touch(const std::string& /*frame*/, const Touch& /*touch*/) {}
    /// Some axes go to a place of the machine; the others stay where they are.
    virtual void go_to(const MachineWay& /*way*/) {}
    /// A work coordinate system is selected, by its name; axis values of a recorded path stay those of the
    /// machine.
    virtual void work_offset(const std::string& /*name*/) {}
    virtual void dwell(double seconds) = 0;
    /// From the next move on, along the path.
    virtual void acceleration(double mm_s2) = 0;
    virtual void action(const std::string& name) = 0;
    virtual void call(const SubPath& sub_path) = 0;
    /// Something to know about what follows.
    virtual void note(const TargetId& where, std::string_view sentence) = 0;
};

struct MoveOptions {
    double tolerance_mm = 0.01;    ///< How far pieces may be off the path.
    double resolution_mm = 0.001;  ///< Smallest step of a program's numbers.
    ObliqueArcs oblique_arcs = ObliqueArcs::lines;
    bool arcs = true;                        ///< Whether arcs may stay arcs.
    bool arcs_of_turns = false;              ///< Whether one may turn by more than a circle.
    ToolChangeStops tool_change_stops = {};  ///< What is set going again behind a change of the tool.
    /// Where work coordinate systems lie; of those without a place the ranges of X, Y and Z say nothing.
    std::map<std::string, std::optional<Vector>, std::less<>> frames_mm = {};
    /// Machine coordinate of Z that MoveSink::retract() leads to; none: Z has no end above.
    std::optional<double> retract_mm = {};
};

/// Turns the points of a path into moves of the axes. Arcs stay arcs where they lie in a plane of the axes,
/// or the options have a way for oblique ones; otherwise, and where rotary axes move the linear ones along
/// with them, motions are cut into lines.
class AxisMoves {
  public:
    /// What is given must outlive this.
    AxisMoves(const Program& program, const MachineSpace& space, const States& states,
              const std::vector<PathTurns>& turns, const MoveOptions& options)
        : program_(program),
          space_(space),
          states_(states),
          turns_(turns),
          options_(options),
          entries_(rotary_entries(program, states, turns)),
          jet_(has_jet(program)) {}

    /// All of one path that the root leads to. Sub-paths are calls.
    tl::expected<void, Fault> run(std::size_t path, MoveSink& sink) const;

  private:
    const Program& program_;
    const MachineSpace& space_;
    const States& states_;
    const std::vector<PathTurns>& turns_;
    MoveOptions options_;
    std::vector<std::optional<AxisValues>> entries_;  // where the rotary axes stand when each path begins
    bool jet_;
};

}  // namespace gsim::path
