#include <random>

#include <gtest/gtest.h>

#include "motion/kinematics/symmetric_solver.h"
#include "tests/support/random_matrix.h"

namespace gsim::kinematics::dense_test {
namespace {

using tests::random_matrix;

TEST(SolveSymmetric, ReturnsSolution) {
    std::mt19937 random(8);
    for (Eigen::Index size = 1; size <= rrs::kMaxJoints; ++size) {
        const Eigen::MatrixXd root = random_matrix(random, size, size, size);
        const JointMatrix matrix = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
        const rrs::JointPos expected_value = rrs::JointPos::LinSpaced(size, -1, 2);
        EXPECT_LT((solve_symmetric(matrix, matrix * expected_value) - expected_value).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace gsim::kinematics::dense_test
