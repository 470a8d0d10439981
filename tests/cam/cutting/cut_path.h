#pragma once

#include <vector>

#include "cam/drawing/drawing.h"
#include "toolpath/model/path.h"

namespace gsim::cutting {

/// A drawing of closed contours, entity i of kind "piece i".
drawing::Drawing drawing_of(const std::vector<geometry::Contour>& contours);

/// What the jet does on one path of a program: its way while it is on, and its pierce.
struct JetWay {
    geometry::Contour way;
    geometry::Point pierce;
};

/// Follows the sub-paths of a program in order. Fails where the jet is on in a rapid move, or is not off at
/// the end.
std::vector<JetWay> jet_ways(const path::Program& program);

}  // namespace gsim::cutting
