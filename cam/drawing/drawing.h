#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::drawing {

/// What a piece of contour comes from, for messages.
struct Entity {
    std::string kind;      ///< "LINE", "path"
    std::string name;      ///< A DXF handle or an SVG id; may be empty.
    std::size_t line = 0;  ///< 0 where the file's lines mean nothing to its readers.
    /// How far the side of the part below it leans, in deg; above 0 the part is smaller below.
    double bevel_deg = 0;
};

/// "LINE 2F at line 120", or without the line.
std::string shown(const Entity& entity);

/// The contours of a drawing, in mm, y upwards.
struct Drawing {
    std::vector<Entity> entities;           ///< What Vertex::source counts.
    std::vector<geometry::Contour> pieces;  ///< As drawn: in any order, closed or not.
    std::vector<std::string> notes;         ///< What was left out.
};

struct ReadOptions {
    double tolerance_mm = 0.005;      ///< How far arcs may be off the curves they stand for.
    double unit_mm = 0;               ///< What one unit of the drawing is; 0: what the drawing says.
    std::vector<std::string> layers;  ///< Only these, if there are any (DXF).
};

/// A drawing cannot have more lines and arcs than this.
inline constexpr std::size_t kMaxEdges = 500'000;
/// Nor reach further.
inline constexpr double kMaxCoordinate_mm = 5e5;

}  // namespace gsim::drawing
