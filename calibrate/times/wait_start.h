#pragma once

#include <Eigen/Core>

namespace gsim::calibrate {

/// The waits that explain best what is missing of times: least absolute deviations, relative to the times, of
/// figures that are not negative (by least squares that are weighted anew). `counts`: how often each time has
/// each wait, a row a time; `missing_s` and `times_s` of the times. Where a fit begins that would not find
/// figures a thousand times as great as its guess.
Eigen::VectorXd waits_from(const Eigen::MatrixXd& counts, const Eigen::VectorXd& missing_s,
                           const Eigen::VectorXd& times_s);

}  // namespace gsim::calibrate
