#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cam/drawing/affine.h"
#include "cam/drawing/nurbs.h"
#include "geometry/planar/contour.h"

namespace gsim::drawing {

/// An arc of an ellipse: center + cos(t) u + sin(t) v for t over an angle.
struct EllipseArc {
    geometry::Point center, u, v;
    double from_rad = 0;
    double sweep_rad = 0;
};

/// Draws contours in the coordinates of an entity; they arrive where an affine map puts them. Circles stay
/// arcs where the map leaves them round; all other curves become arcs within a tolerance.
class Pen {
  public:
    Pen(std::vector<geometry::Contour>& pieces, double tolerance_mm)
        : pieces_(pieces), tolerance_mm_(tolerance_mm) {}

    /// What is drawn from now on, and where it goes.
    void take(const Affine& map, std::uint32_t source);
    void move_to(geometry::Point point);
    void line_to(geometry::Point point);
    /// An edge with a bulge (geometry::Edge).
    void bulge_to(geometry::Point point, double bulge);
    /// Begins where the pen is, but for rounding.
    void arc(const EllipseArc& arc);
    void nurbs(const Nurbs& curve);
    /// A line back to where move_to() was; the pen is there then.
    void close();
    /// Ends the contour; needed before the pieces are looked at.
    void lift();

    /// What could not be drawn since take(), as the end of a sentence.
    const std::optional<std::string>& fault() const { return fault_; }

  private:
    void add(const geometry::Edge& edge);
    void check(geometry::Point point);

    std::vector<geometry::Contour>& pieces_;
    double tolerance_mm_;
    Affine map_;
    std::uint32_t source_ = 0;
    geometry::Contour contour_;
    geometry::Point start_, here_;  // as the entity has them
    std::size_t edges_ = 0;
    std::optional<std::string> fault_;
};

}  // namespace gsim::drawing
