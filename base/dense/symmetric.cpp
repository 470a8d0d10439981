#include "base/dense/symmetric.h"

#include <Eigen/Cholesky>

#include "base/dense/singular.h"

namespace gsim::base {

// The norm is added to each eigenvalue, so that none is below 0. Then they are the singular values, for which
// singular_values() exists anyway. Eigen's own solver would add four seconds to each build.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
    const double shift = matrix.norm();
    Eigen::MatrixXd shifted = matrix;
    shifted.diagonal().array() += shift;
    return singular_values(shifted).values.reverse().array() - shift;
}

bool is_positive_definite(const Eigen::MatrixXd& matrix) {
    const Eigen::LDLT<Eigen::MatrixXd> cholesky(matrix);
    return (cholesky.vectorD().array() > 0).all();
}

Eigen::MatrixXd solve_positive_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
    return matrix.ldlt().solve(right);
}

Eigen::MatrixXd positive_definite_inverse(const Eigen::MatrixXd& matrix) {
    return solve_positive_definite(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

}  // namespace gsim::base
