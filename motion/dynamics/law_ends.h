#pragma once

#include <vector>

#include "motion/segment/segment.h"

namespace gsim::dynamics {

/// Adds the ends of the parts of all time laws of a segment, including those of superimposed motion, in no
/// order, in s since its start. Between two neighbouring ends all laws are polynomials.
void add_law_ends(const motion::Segment& segment, std::vector<double>& ends_s);

}  // namespace gsim::dynamics
