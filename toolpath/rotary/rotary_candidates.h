#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "toolpath/rotary/machine_space.h"

namespace gsim::path {

/// Rounding of a turn.
inline constexpr double kTurnTolerance_deg = 1e-6;

/// Returns the cost between two rotary positions: how far all axes turn from one to the other, deg.
double turn_between(const AxisValues& from, const AxisValues& to);
/// Returns the same modulo full turns of each axis.
double min_turn_between(const AxisValues& from, const AxisValues& to);

/// Adds values that differ from `values` in full turns and lie in the axes' ranges, unless they are present;
/// for an endless axis, the ones nearest to `near`.
void add_full_turns(const MachineSpace& space, const AxisValues& values, const AxisValues& near,
                    std::vector<AxisValues>& out);

/// Returns all rotary values within the axes' ranges that give a point's orientation, as seen from the
/// possible axis values before it (at least one). `is_literal`: rotary_deg is taken literally.
Result<std::vector<AxisValues>> rotary_candidates(const MachineSpace& space, const Vector& tcp_mm,
                                                  const Orientation& orientation,
                                                  const std::vector<AxisValues>& before, bool is_literal);

}  // namespace gsim::path
