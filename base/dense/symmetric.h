#pragma once

#include <Eigen/Core>

namespace gsim::base {

// Decompositions of symmetric matrices of any size. All expect a square matrix with finite elements. The
// functions based on Cholesky's decomposition read only the lower triangle.

/// Returns the eigenvalues in ascending order, each to about 1e-16 of the largest magnitude.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// True if all eigenvalues are above 0. Uses Cholesky's decomposition, which is much faster than computing
/// the eigenvalues.
bool is_positive_definite(const Eigen::MatrixXd& matrix);

/// Returns the solution x of matrix * x = right for a positive definite matrix (Cholesky, LDL^T with pivots).
Eigen::MatrixXd solve_positive_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Returns the inverse of a positive definite matrix.
Eigen::MatrixXd positive_definite_inverse(const Eigen::MatrixXd& matrix);

}  // namespace gsim::base
