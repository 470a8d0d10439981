#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cam/drawing/drawing.h"

namespace gsim::cutting {

/// A closed contour of a drawing with what lies around it. Material is to its left: the outside of a part
/// runs counter-clockwise, a hole clockwise.
struct Outline {
    geometry::Contour contour;
    std::optional<std::size_t> parent;  ///< The outline around it.
    std::size_t depth = 0;              ///< Even: the outside of a part. Odd: a hole.
};

/// The way of the jet's middle along an outline, half of the kerf off to its right. An outline with a narrow
/// place may need several.
struct Loop {
    geometry::Contour contour;
    std::size_t outline = 0;
};

/// All that is to be cut out of a drawing.
struct Layout {
    std::vector<Outline> outlines;
    std::vector<Loop> loops;         ///< Those of one outline stand together, the largest last.
    std::vector<std::string> notes;  ///< What is not cut as it was drawn.
};

struct LayoutOptions {
    double kerf_mm = 0;
    double gap_mm = 0.02;  ///< Ends that are nearer than this are joined.
};

/// Closes the contours of a drawing, nests and offsets them. The error is a sentence that names entities and
/// places: ends that stay open, contours that cross or touch, holes that are narrower than the kerf.
tl::expected<Layout, std::string> lay_out(drawing::Drawing drawing, const LayoutOptions& options);

}  // namespace gsim::cutting
