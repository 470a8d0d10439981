#pragma once

#include <cstdint>
#include <vector>

#include "calibrate/geometry/tcp_errors.h"

namespace gsim::calibrate {

/// Returns the poses as an instrument would measure them on `geometry`, with normal noise of these standard
/// deviations. The same seed gives the same noise.
std::vector<MeasuredTcp> simulated_tcps(const Geometry& geometry, std::vector<MeasuredTcp> poses,
                                        const Noise& noise, std::uint64_t seed);

/// Draws values of deviations for a simulated machine: normal, with `share` of their usual sizes as standard
/// deviation.
Eigen::VectorXd random_deviations(const std::vector<Deviation>& deviations, double share, std::uint64_t seed);

/// Simulated machine that deviates in all parameters that TCPs at `poses` can determine.
struct GroundTruth {
    Geometry geometry;
    std::vector<Deviation> deviations;
    Eigen::VectorXd values;
};
GroundTruth make_ground_truth(const machine::Machine& machine, const std::vector<MeasuredTcp>& poses,
                              const DeviationOptions& deviation_options, std::uint64_t seed);

}  // namespace gsim::calibrate
