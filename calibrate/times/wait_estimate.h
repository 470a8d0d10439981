#pragma once

#include <Eigen/Core>

namespace gsim::calibrate {

/// Returns the waits that best explain the missing times: least absolute deviations, relative to the times,
/// of non-negative values (by reweighted least squares). `counts`: number of each wait in each time, a row a
/// time; `missing_s` and `times_s` of the times. This is the start of a fit that would not find values a
/// thousand times as large as its guess.
Eigen::VectorXd estimate_waits(const Eigen::MatrixXd& counts, const Eigen::VectorXd& missing_s,
                               const Eigen::VectorXd& times_s);

}  // namespace gsim::calibrate
