#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "toolpath/model/states.h"
#include "toolpath/rotary/machine_space.h"
#include "toolpath/rotary/rotary_schedule.h"

namespace gsim::path {

struct RotaryOptions {
    bool is_literal =
        false;  ///< rotary_deg gives axis positions, not an orientation that full turns may lead to.
};

/// Chooses from all rotary values that give each point's orientation within the axes' ranges: those that turn
/// least over the complete path (dynamic programming over the points). While the tool cuts, axes take the
/// short turn. If their ranges do not allow it, the tool stops and the axes unwind, as seldom as possible.
/// Each path is planned by itself, because all its users share it. Returns one RotarySchedule for each path.
tl::expected<std::vector<RotarySchedule>, TargetError> plan_rotary(const Program& program,
                                                                   const MachineSpace& space,
                                                                   const States& states,
                                                                   const RotaryOptions& options);

/// Returns true if a point is reached while the tool cuts: its motion is at feed, and the waterjet is on or
/// the program has none.
bool is_cutting(const Point& point, const State& before, bool program_has_jet);

/// Returns true if any action of the program turns a waterjet on.
bool has_jet(const Program& program);

}  // namespace gsim::path
