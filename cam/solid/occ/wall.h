#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Vec.hxx>
#include <optional>

namespace gsim::solid {

/// A direction down a wall, of length 1, the length of the wall along it, and its outward normal there.
struct WallLine {
    gp_Vec direction{0, 0, 0};
    double depth_mm = 0;
    gp_Vec exit_normal{0, 0, 0};
};

/// The face across an edge, along which the jet runs down.
class Wall {
  public:
    /// `allows_curved_edge`: an edge may be curved within a plane wall without side edges at its ends, such
    /// as a part of a longer edge of that wall. Loops of one face have such edges only if the jet cannot cut
    /// along the wall.
    Wall(const TopoDS_Edge& edge, const TopoDS_Face& wall, bool allows_curved_edge = false);

    /// Returns the normal out of the material, at a parameter of the edge's curve.
    std::optional<gp_Dir> normal(double parameter) const;
    /// Returns the straight line in the wall that begins at that point of the edge. In a plane wall it turns
    /// from one side edge to the other, so walls that meet in a corner have one line there. If the edge has
    /// no side edge at an end, as within a side of several edges, it is perpendicular to the edge. Returns
    /// nothing if no line of the wall is straight.
    std::optional<WallLine> line(double parameter) const;

  private:
    std::optional<gp_Vec> inward_direction(double parameter) const;
    void find_sides();
    std::optional<gp_Vec> side_at(double parameter, bool first) const;
    std::optional<double> reach_mm(double parameter, const gp_Vec& direction) const;
    WallLine plane_line(double parameter) const;
    std::optional<WallLine> iso_line(double parameter, bool is_along_u) const;

    TopoDS_Edge edge_;
    TopoDS_Face wall_;
    BRepAdaptor_Curve curve_;
    BRepAdaptor_Curve2d wall_curve_;
    bool plane_ = false;
    bool allows_curved_edge_ = false;
    double sense_ = 1;  ///< -1: the edge runs in reverse in the wall.
    double u_low_ = 0, u_high_ = 0, v_low_ = 0, v_high_ = 0;
    std::optional<gp_Vec> first_side_, last_side_;  ///< For a plane wall, with their lengths.
};

}  // namespace gsim::solid
