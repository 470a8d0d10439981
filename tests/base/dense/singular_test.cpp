#include "base/dense/singular.h"

#include <Eigen/SVD>
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/random_matrix.h"

namespace gsim::base::singular_test {
namespace {

using tests::random_matrix;

TEST(SingularValues, MatchEigenJacobiSvd) {
    std::mt19937 random(7);
    for (Eigen::Index rows = 3; rows <= 6; ++rows) {
        for (Eigen::Index cols = 1; cols <= 9; ++cols) {
            for (Eigen::Index rank = 1; rank <= std::min(rows, cols); ++rank) {
                const Eigen::MatrixXd matrix = random_matrix(random, rows, cols, rank);
                const Eigen::JacobiSVD<Eigen::MatrixXd> expected(matrix, Eigen::ComputeThinV);
                const SingularValues found = singular_values(matrix);
                ASSERT_EQ(found.values.size(), expected.singularValues().size());
                EXPECT_LT((found.values - expected.singularValues()).norm(), 1e-12 * found.values[0]);
                // Right vectors of length 1, across each other, and as long under the matrix as their values
                // say.
                const Eigen::MatrixXd across = found.right.transpose() * found.right;
                EXPECT_TRUE(across.isIdentity(1e-12)) << rows << " x " << cols << ", rank " << rank;
                const Eigen::MatrixXd images = matrix * found.right;
                for (Eigen::Index i = 0; i < found.values.size(); ++i)
                    EXPECT_NEAR(images.col(i).norm(), found.values[i], 1e-12 * found.values[0]);
            }
        }
    }
}

TEST(SingularValues, AreZeroForZeroMatrix) {
    const SingularValues found = singular_values(Eigen::MatrixXd::Zero(6, 5));
    EXPECT_EQ(found.values, Eigen::VectorXd::Zero(5));
    EXPECT_TRUE((found.right.transpose() * found.right).isIdentity(1e-15));
}

}  // namespace
}  // namespace gsim::base::singular_test
