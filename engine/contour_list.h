#pragma once

#include <array>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/contours.h"
#include "engine/diagnostic.h"
#include "engine/host.h"

namespace gsim::engine {

/// A contour that could be cut, for display and selection (ContourSelection::edges).
struct ListedContour {
    std::string face = {};  ///< As messages name it, of which it is.
    bool is_hole = false;
    bool is_open = false;                 ///< A chain of edges.
    std::vector<std::string> edges = {};  ///< Their numbers in the file; empty if they have none.
    double length_mm = 0;
    double depth_mm = 0;  ///< The max depth of a wall below it.
    double tilt_deg = 0;  ///< The max tilt of a wall from the face's normal.
    std::vector<std::array<double, 3>> polyline_mm =
        {};  ///< Positions along it, of the file; if closed, the last is the first.
};

struct ContourList {
    std::vector<ListedContour> contours = {};
    std::vector<std::string> notes = {};  ///< Messages about omitted elements of the part.
};

/// Returns the contours that a choice selects in a STEP or IGES file, which is named as
/// DrawingRequest::drawing is, and read by Host::read_contours.
GSIM_API tl::expected<ContourList, Error> list_contours(const Host& host, const std::string& part,
                                                        const ContourSelection& selection);

}  // namespace gsim::engine
