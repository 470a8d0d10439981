#pragma once

#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <string>

#include "geometry/planar/point.h"

namespace gsim::solid {

/// Two heights that differ by less than this, in mm, count as equal.
inline constexpr double kHeightTolerance_mm = 0.01;

/// The upper side of a plate as the plane of a drawing.
class PlateFrame {
  public:
    /// `up` points out of the material. The drawing's x axis is the file's X as seen from there, or its Y if
    /// X points up or down; its origin is the file's.
    PlateFrame(const gp_Pnt& plane_point, const gp_Dir& up);

    const gp_Dir& up() const { return up_; }
    geometry::Point to_plane(const gp_Pnt& point) const;
    geometry::Point to_plane(const gp_Vec& vector) const;
    /// Returns the height over the plane.
    double height_mm(const gp_Pnt& point) const;

  private:
    gp_Pnt plane_point_;
    gp_Dir up_, x_, y_;
};

/// Returns "(1, 2, 3)".
std::string display_text(const gp_Pnt& point);

}  // namespace gsim::solid
