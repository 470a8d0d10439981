#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <string>

#include <tl/expected.hpp>

#include "cam/drawing/drawing.h"
#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

/// Draws edges that lie in a plate's upper side.
class OutlinePen {
  public:
    OutlinePen(const PlateFrame& frame, double tolerance_mm, drawing::Drawing& drawing)
        : frame_(frame), tolerance_mm_(tolerance_mm), drawing_(drawing) {}

    /// A stretch of a curve between two of its parameters as an entity of its own. Lines and circles stay
    /// what they are. The error is a sentence.
    tl::expected<void, std::string> draw(const BRepAdaptor_Curve& curve, double from, double to,
                                         const std::string& name, double bevel_deg);

  private:
    std::uint32_t add_entity(const BRepAdaptor_Curve& curve, const std::string& name, double bevel_deg);
    void draw_circle(const BRepAdaptor_Curve& curve, double from, double to, geometry::Contour& piece) const;
    void draw_fitted(const BRepAdaptor_Curve& curve, double from, double to, geometry::Contour& piece) const;
    tl::expected<void, std::string> check(const geometry::Contour& piece) const;

    const PlateFrame& frame_;
    double tolerance_mm_;
    drawing::Drawing& drawing_;
    std::size_t edges_ = 0;
    std::uint32_t source_ = 0;
};

}  // namespace gsim::solid
