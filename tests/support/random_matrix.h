#pragma once

#include <Eigen/Core>
#include <random>

namespace gsim::tests {

/// A matrix of this rank, the product of two random factors.
inline Eigen::MatrixXd random_matrix(std::mt19937& random, Eigen::Index rows, Eigen::Index cols,
                                     Eigen::Index rank) {
    std::normal_distribution<double> number;
    const auto filled = [&](Eigen::Index m, Eigen::Index n) {
        return Eigen::MatrixXd::NullaryExpr(m, n, [&] { return number(random); }).eval();
    };
    return filled(rows, rank) * filled(rank, cols);
}

}  // namespace gsim::tests
