#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "calibrate/geometry/deviation.h"

namespace gsim::calibrate {

/// Deviation that stays 0, and the reason: "moves no tip", or the others with the same effect.
struct FixedDeviation {
    std::string name;
    std::string reason;
};

/// Information of measurements about a list of deviations.
struct Identification {
    std::vector<std::size_t> selected;  ///< Indices of the distinguishable ones, in ascending order.
    std::vector<FixedDeviation> fixed;  ///< All others.
    Eigen::VectorXd
        singular_values;  ///< For all, in usual sizes over noise: above 1 a combination is determined.
};

/// Identifies the determined deviations. `slopes` are derivatives of errors in units of their noise, a column
/// for each deviation. It counts combinations of deviations that are determined to better than their usual
/// size (singular values). So many deviations are chosen, the first distinguishable ones of the list.
Identification identify(const Eigen::MatrixXd& slopes, std::span<const Deviation> deviations);

}  // namespace gsim::calibrate
