#pragma once

#include <cstdint>
#include <vector>

#include "calibrate/geometry/tip_errors.h"

namespace gsim::calibrate {

/// Returns the poses as an instrument would measure them on `geometry`, with normal noise of these standard
/// deviations. The same seed gives the same noise.
std::vector<MeasuredTip> simulated(const Geometry& geometry, std::vector<MeasuredTip> poses,
                                   const Noise& noise, std::uint64_t seed);

/// Draws values of deviations for a simulated machine: normal, with `share` of their usual sizes as standard
/// deviation.
Eigen::VectorXd drawn_values(const std::vector<Deviation>& deviations, double share, std::uint64_t seed);

/// Simulated machine that deviates in all parameters that TCPs at `poses` can determine.
struct HiddenMachine {
    Geometry geometry;
    std::vector<Deviation> deviations;
    Eigen::VectorXd values;
};
HiddenMachine hidden_machine(const machine::Machine& machine, const std::vector<MeasuredTip>& poses,
                             const DeviationChoice& choice, std::uint64_t seed);

}  // namespace gsim::calibrate
