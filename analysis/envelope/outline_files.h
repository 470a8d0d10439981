#pragma once

#include <string>
#include <vector>

#include "analysis/envelope/outline.h"

namespace gsim::envelope {

/// Returns outlines as a table: axes, plane or surface, curve, closed, x_mm, y_mm, z_mm; one row for each
/// point.
std::string to_csv(const machine::Machine& machine, const std::vector<PairOutline>& outlines);

/// Returns a picture of each outline: in its plane or, if it has none, in that of the coordinates in which it
/// is widest.
std::string to_svg(const machine::Machine& machine, const std::vector<PairOutline>& outlines);

}  // namespace gsim::envelope
