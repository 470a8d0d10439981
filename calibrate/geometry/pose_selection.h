#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/geometry/deviation.h"
#include "calibrate/geometry/measured_tcp.h"

namespace gsim::calibrate {

/// Returns so many poses within the ranges of the axes (joint_box(), a little in from its ends) that
/// determine most of a machine's deviations. The method is D-optimal: the best of some hundred candidates are
/// added one by one and then exchanged (Fedorov 1972). TCPs are those of the file. Collisions are not
/// checked. The error: too few to determine everything that any poses would.
Result<std::vector<MeasuredTcp>> suggest_poses(const machine::Machine& machine, std::size_t count,
                                               bool orientation, const DeviationOptions& deviation_options);

/// Returns a part program (G-code of most controllers) that moves to each pose by rapids in machine
/// coordinates and waits there for a measurement.
std::string pose_program(const std::vector<MeasuredTcp>& poses, const machine::Machine& machine);

/// Returns poses spread evenly over the same ranges: `first` distinguishes them from others.
std::vector<MeasuredTcp> spread_poses(const machine::Machine& machine, int first, std::size_t count,
                                      bool orientation);

}  // namespace gsim::calibrate
