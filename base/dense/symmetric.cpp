#include "base/dense/symmetric.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace gsim::base {

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
    return matrix.ldlt().solve(right);
}

Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix) {
    return solve_positive(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

}  // namespace gsim::base
