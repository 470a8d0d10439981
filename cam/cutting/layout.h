#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cam/drawing/drawing.h"

namespace gsim::cutting {

/// A closed contour of a drawing with its nesting. Material is to its left: the outside of a part runs
/// counter-clockwise, a hole clockwise.
struct Outline {
    geometry::Contour contour;
    std::optional<std::size_t> parent;  ///< The outline around it.
    std::size_t depth = 0;              ///< Even: the outside of a part. Odd: a hole.
};

/// The path of the jet's center along an outline, offset by half of the kerf to its right. An outline with a
/// narrow section may need several.
struct Loop {
    geometry::Contour contour;
    std::size_t outline = 0;
};

/// All contours to cut out of a drawing.
struct Layout {
    std::vector<Outline> outlines;
    std::vector<Loop> loops;         ///< Loops of one outline are adjacent, the largest last.
    std::vector<std::string> notes;  ///< Deviations from the drawing.
};

struct LayoutOptions {
    double kerf_mm = 0;
    double gap_mm = 0.02;  ///< Ends that are nearer than this are joined.
};

/// Closes the contours of a drawing, nests and offsets them. The error message names entities and positions:
/// ends that stay open, contours that cross or touch, holes that are narrower than the kerf.
Result<Layout> make_layout(drawing::Drawing drawing, const LayoutOptions& options);

}  // namespace gsim::cutting
