#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "calibrate/geometry/deviation.h"

namespace gsim::calibrate {

/// A deviation that stays 0, and why: "moves no tip", or which others do the same.
struct HeldDeviation {
    std::string name;
    std::string why;
};

/// What measurements tell of a list of deviations.
struct Identified {
    std::vector<std::size_t> chosen;  ///< Indices of those that can be told from each other, rising.
    std::vector<HeldDeviation> held;  ///< All others.
    Eigen::VectorXd singular_values;  ///< Of all, in usual sizes over noise: above 1 a combination is told.
};

/// `slopes` are derivatives of errors in units of their noise, a column for each deviation. Combinations of
/// deviations count that are told to better than their usual size (singular values); so many deviations are
/// chosen, the first ones of the list that can be told apart.
Identified identify(const Eigen::MatrixXd& slopes, std::span<const Deviation> deviations);

}  // namespace gsim::calibrate
