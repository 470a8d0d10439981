#pragma once

#include <Eigen/Core>

namespace gsim::base {

// Decompositions of symmetric matrices of any size. All expect a square matrix with finite elements. What
// Cholesky's takes reads the lower triangle alone.

/// The eigenvalues in ascending order, each to about 1e-16 of the greatest magnitude.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// Whether all eigenvalues are above 0, by Cholesky's decomposition: much faster than the eigenvalues.
bool is_positive_definite(const Eigen::MatrixXd& matrix);

/// The solution x of matrix * x = right for a positive definite matrix (Cholesky, LDL^T with pivots).
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The inverse of a positive definite matrix.
Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix);

}  // namespace gsim::base
