#pragma once

#include <Eigen/Core>

namespace gsim::base {

// Eigen's decompositions of symmetric matrices of any size. All expect a square matrix with finite elements
// and read its lower triangle alone.

/// The eigenvalues in ascending order.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

struct SymmetricEigen {
    Eigen::VectorXd values;   ///< In ascending order.
    Eigen::MatrixXd vectors;  ///< A column of length 1 for each value.
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

/// The solution x of matrix * x = right for a positive definite matrix (Cholesky, LDL^T with pivots).
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The inverse of a positive definite matrix.
Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix);

}  // namespace gsim::base
