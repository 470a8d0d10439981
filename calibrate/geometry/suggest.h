#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/geometry/deviation.h"
#include "calibrate/geometry/measured_tip.h"

namespace gsim::calibrate {

/// As many poses within the ranges of the axes (joint_box(), a little in from its ends) as tell most of a
/// machine's deviations: D-optimal, by adding the best of some hundred candidates one by one and then
/// exchanging them (Fedorov 1972). Tips are those of the file. Collisions are not looked at. The error: there
/// are too few to tell of all that any poses would.
tl::expected<std::vector<MeasuredTip>, std::string> suggest_poses(const machine::Machine& machine,
                                                                  std::size_t count, bool orientation,
                                                                  const DeviationChoice& choice);

/// A part program (G-code of most controls) that goes to each pose by rapids in machine coordinates and waits
/// there for a measurement.
std::string pose_program(const std::vector<MeasuredTip>& poses, const machine::Machine& machine);

/// Poses spread evenly over the same ranges: `first` tells them from others.
std::vector<MeasuredTip> spread_poses(const machine::Machine& machine, int first, std::size_t count,
                                      bool orientation);

}  // namespace gsim::calibrate
