#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::drawing {

/// The source of a contour, for messages.
struct Entity {
    std::string kind;      ///< "LINE", "path"
    std::string name;      ///< A DXF handle or an SVG id; may be empty.
    std::size_t line = 0;  ///< 0 if lines of the file mean nothing to users.
    /// Tilt of the part's side below it, in deg; above 0 the part is smaller below.
    double bevel_deg = 0;
};

/// Returns "LINE 2F at line 120", or the text without the line.
std::string display_text(const Entity& entity);

/// The contours of a drawing, in mm, y upwards.
struct Drawing {
    std::vector<Entity> entities;                   ///< Vertex::source is an index into it.
    std::vector<geometry::Contour> drawn_contours;  ///< As drawn: in any order, closed or not.
    std::vector<std::string> notes;                 ///< Elements left out.
};

struct ReadOptions {
    double tolerance_mm = 0.005;      ///< Max deviation of arcs from the curves they replace.
    double unit_mm = 0;               ///< Size of one unit of the drawing; 0: as the drawing says.
    std::vector<std::string> layers;  ///< Only these, if there are any (DXF).
};

/// Max number of lines and arcs of a drawing.
inline constexpr std::size_t kMaxEdges = 500'000;
/// Max coordinate of a drawing.
inline constexpr double kMaxCoordinate_mm = 5e5;

}  // namespace gsim::drawing
