#pragma once

#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <string>

#include "geometry/planar/point.h"

namespace gsim::solid {

/// Nearer than this, in mm, two heights are one.
inline constexpr double kSameHeight_mm = 0.01;

/// The upper side of a plate as the plane of a drawing.
class PlateFrame {
  public:
    /// `up` points out of the material. The drawing's x axis is the file's X as it is seen from there, or its
    /// Y where X points up or down; its origin is the file's.
    PlateFrame(const gp_Pnt& on_plane, const gp_Dir& up);

    const gp_Dir& up() const { return up_; }
    geometry::Point in_plane(const gp_Pnt& point) const;
    geometry::Point in_plane(const gp_Vec& vector) const;
    /// Above the plane.
    double height_mm(const gp_Pnt& point) const;

  private:
    gp_Pnt on_plane_;
    gp_Dir up_, x_, y_;
};

/// "(1, 2, 3)"
std::string shown(const gp_Pnt& point);

}  // namespace gsim::solid
