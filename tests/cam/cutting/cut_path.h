#pragma once

#include <vector>

#include "cam/drawing/drawing.h"
#include "toolpath/model/path.h"

namespace gsim::cutting {

/// Returns a drawing of closed contours, with entity i of kind "piece i".
drawing::Drawing drawing_of(const std::vector<geometry::Contour>& contours);

/// Jet on one path of a program: its path while it is on, and its pierce.
struct JetPath {
    geometry::Contour jet_path;
    geometry::Point pierce;
};

/// Returns the paths of the jet along the sub-paths of a program, in order. Fails if the jet is on in a rapid
/// move, or is not off at the end.
std::vector<JetPath> jet_ways(const path::Program& program);

}  // namespace gsim::cutting
