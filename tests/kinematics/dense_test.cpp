#include "runtime/kinematics/dense.h"

#include <random>

#include <gtest/gtest.h>

namespace gsim::kinematics::dense_test {
namespace {

// A matrix of a rank that is known, of two factors.
Eigen::MatrixXd random_matrix(std::mt19937& random, Eigen::Index rows, Eigen::Index cols, Eigen::Index rank) {
    std::normal_distribution<double> number;
    const auto filled = [&](Eigen::Index m, Eigen::Index n) {
        return Eigen::MatrixXd::NullaryExpr(m, n, [&] { return number(random); }).eval();
    };
    return filled(rows, rank) * filled(rank, cols);
}

TEST(SolveSymmetric, GivesTheSolution) {
    std::mt19937 random(8);
    for (Eigen::Index size = 1; size <= rrs::kMaxJoints; ++size) {
        const Eigen::MatrixXd root = random_matrix(random, size, size, size);
        const JointSquare matrix = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
        const rrs::JointPos wanted = rrs::JointPos::LinSpaced(size, -1, 2);
        EXPECT_LT((solve_symmetric(matrix, matrix * wanted) - wanted).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace gsim::kinematics::dense_test
