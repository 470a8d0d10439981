#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <string>

#include "base/error.h"
#include "cam/drawing/drawing.h"
#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

/// A pen that draws edges in a plate's upper side.
class OutlinePen {
  public:
    OutlinePen(const PlateFrame& frame, double tolerance_mm, drawing::Drawing& drawing)
        : frame_(frame), tolerance_mm_(tolerance_mm), drawing_(drawing) {}

    /// Draws a part of a curve between two of its parameters as a separate entity. Lines and circles keep
    /// their type.
    Result<void> draw(const BRepAdaptor_Curve& curve, double from, double to, const std::string& name,
                      double bevel_deg);

  private:
    std::uint32_t add_entity(const BRepAdaptor_Curve& curve, const std::string& name, double bevel_deg);
    void draw_circle(const BRepAdaptor_Curve& curve, double from, double to,
                     geometry::Contour& drawn_contour) const;
    void draw_fitted(const BRepAdaptor_Curve& curve, double from, double to,
                     geometry::Contour& drawn_contour) const;
    Result<void> check(const geometry::Contour& drawn_contour) const;

    const PlateFrame& frame_;
    double tolerance_mm_;
    drawing::Drawing& drawing_;
    std::size_t edges_ = 0;
    std::uint32_t source_ = 0;
};

}  // namespace gsim::solid
