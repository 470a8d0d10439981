#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "toolpath/rotary/machine_space.h"

namespace gsim::path {

/// What is added up of two rotary positions: how far all axes turn from one to the other, deg.
double turn_between(const AxisValues& from, const AxisValues& to);
/// The same modulo whole turns of each axis.
double least_turn_between(const AxisValues& from, const AxisValues& to);

/// Adds what differs from `values` in whole turns and lies in the axes' ranges, unless it is there; of an
/// endless axis, what is nearest to `near`.
void add_whole_turns(const MachineSpace& space, const AxisValues& values, const AxisValues& near,
                     std::vector<AxisValues>& out);

/// All rotary values within the axes' ranges that give a point's orientation, as seen from where the axes may
/// stand before it (at least one). `as_given`: rotary_deg is taken literally. The error is a sentence.
tl::expected<std::vector<AxisValues>, std::string> rotary_candidates(const MachineSpace& space,
                                                                     const Vector& tip_mm,
                                                                     const Orientation& orientation,
                                                                     const std::vector<AxisValues>& before,
                                                                     bool as_given);

}  // namespace gsim::path
