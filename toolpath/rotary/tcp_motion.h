#pragma once

#include <functional>
#include <optional>

#include "toolpath/model/arc_shape.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::path {

/// One motion of the TCP with the rotary axes in proportion to it.
class TcpMotion {
  public:
    /// Makes a line, or an arc if `arc` is given. `start_rotary` may be empty: then it is as at the end.
    TcpMotion(const MachineSpace& space, const Eigen::Vector3d& start_mm, const Eigen::Vector3d& end_mm,
              const AxisValues& start_rotary, const AxisValues& end_rotary, std::optional<ArcShape> arc);

    AxisValues at(double share) const;
    double length_mm() const;
    const std::optional<ArcShape>& arc() const { return arc_; }
    double turn_deg() const;

    /// Returns true if the tool tilts against an arc's normal at both of its ends but hardly between them. A
    /// tool that tilts along an arc is meant to turn with it.
    bool tilts_through_vertical() const;
    /// Returns true if a single linear move of the axes keeps the TCP within the tolerance of the line.
    bool is_axis_line(double tolerance_mm) const;
    /// Returns the arc of the axes from one share to another, if it is one in a plane of the axes, within the
    /// tolerance.
    std::optional<AxisArc> axis_arc(double from, double to, double tolerance_mm) const;
    /// Returns the arc of the axes from one share to another in an oblique plane, defined by the point
    /// halfway; nullopt for a helix, and if turning axes move the linear ones.
    std::optional<AxisArc> oblique_arc(double from, double to, double tolerance_mm) const;
    /// Calls `on_part` with the shares at which lines between them keep within the tolerance; the last is 1.
    void cut(double tolerance_mm, const std::function<void(double share)>& on_part) const;

  private:
    Eigen::Vector3d tcp(double share) const;
    int quarter_turn_count(double from, double to) const;
    double deviation(double from, double to) const;

    const MachineSpace& space_;
    Eigen::Vector3d start_, end_;
    AxisValues start_rotary_, end_rotary_;
    std::optional<ArcShape> arc_;
};

}  // namespace gsim::path
