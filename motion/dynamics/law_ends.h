#pragma once

#include <vector>

#include "motion/segment/segment.h"

namespace gsim::dynamics {

/// Adds the ends of the pieces of all time laws of a segment, those of what goes on beside it among them, in
/// no order, in s since its start: between two that are neighbours all laws are polynomials.
void add_law_ends(const motion::Segment& segment, std::vector<double>& ends_s);

}  // namespace gsim::dynamics
