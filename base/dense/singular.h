#pragma once

#include <Eigen/Core>

namespace gsim::base {

/// Singular values, largest first, and the right singular vectors as columns.
struct SingularValues {
    Eigen::VectorXd values;
    Eigen::MatrixXd right;
};
SingularValues singular_values(const Eigen::MatrixXd& matrix);

}  // namespace gsim::base
