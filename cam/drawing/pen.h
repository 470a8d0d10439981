#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
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

/// A pen that draws contours in the coordinates of an entity and maps them with an affine map. Circles stay
/// arcs if the map keeps them round; all other curves become arcs within a tolerance.
class Pen {
  public:
    Pen(std::vector<geometry::Contour>& drawn_contours, double tolerance_mm)
        : drawn_contours_(drawn_contours), tolerance_mm_(tolerance_mm) {}

    /// Sets the map and the source of the following contours.
    void set_map(const Affine& map, std::uint32_t source);
    void move_to(geometry::Point point);
    void line_to(geometry::Point point);
    /// Draws an edge with a bulge (geometry::Edge).
    void bulge_to(geometry::Point point, double bulge);
    /// Draws an arc that begins at the pen's position, except for rounding.
    void arc(const EllipseArc& arc);
    void nurbs(const Nurbs& curve);
    /// Draws a line back to the point of move_to(), which is then the pen's position.
    void close();
    /// Ends the contour; required before the contours are read.
    void lift();

    /// Returns the error since take(), as the end of a message.
    const std::optional<Error>& error() const { return error_; }

  private:
    void add(const geometry::Edge& edge);
    void check(geometry::Point point);

    std::vector<geometry::Contour>& drawn_contours_;
    double tolerance_mm_;
    Affine map_;
    std::uint32_t source_ = 0;
    geometry::Contour contour_;
    geometry::Point start_, current_;  // as the entity has them
    std::size_t edges_ = 0;
    std::optional<Error> error_;
};

}  // namespace gsim::drawing
