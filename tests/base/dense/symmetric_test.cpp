#include "base/dense/symmetric.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace gsim::base {
namespace {

/// Returns the matrix of the second difference with known eigenvalues: 2 - 2 cos(k pi / (size + 1)).
Eigen::MatrixXd second_difference(Eigen::Index size) {
    Eigen::MatrixXd matrix = 2 * Eigen::MatrixXd::Identity(size, size);
    matrix.diagonal(1).setConstant(-1);
    matrix.diagonal(-1).setConstant(-1);
    return matrix;
}

double eigenvalue_of_difference(Eigen::Index k, Eigen::Index size) {
    return 2 - 2 * std::cos(static_cast<double>(k) * std::numbers::pi / static_cast<double>(size + 1));
}

TEST(Symmetric, EigenvaluesAscend) {
    for (const Eigen::Index size : {1, 2, 3, 17}) {
        const Eigen::VectorXd values = symmetric_eigenvalues(second_difference(size));
        ASSERT_EQ(values.size(), size);
        for (Eigen::Index k = 0; k < size; ++k)
            EXPECT_NEAR(values[k], eigenvalue_of_difference(k + 1, size), 1e-13) << size;
    }
}

TEST(Symmetric, SolvesAndInverts) {
    // The inverse of the second difference: min(i, k) (size + 1 - max(i, k)) / (size + 1).
    const Eigen::Index size = 6;
    const Eigen::MatrixXd matrix = second_difference(size);
    const Eigen::MatrixXd inverse = positive_definite_inverse(matrix);
    for (Eigen::Index i = 1; i <= size; ++i) {
        for (Eigen::Index k = 1; k <= size; ++k) {
            const auto less = static_cast<double>(std::min(i, k)), more = static_cast<double>(std::max(i, k));
            EXPECT_NEAR(inverse(i - 1, k - 1), less * (7 - more) / 7, 1e-13);
        }
    }
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(size, 2);
    EXPECT_TRUE((matrix * solve_positive_definite(matrix, right)).isApprox(right, 1e-12));
}

TEST(Symmetric, FindsEigenvaluesOfBothSigns) {
    // A reflection in the plane across (1, 2, 2) / 3, stretched: -5 along it, 5 across.
    const Eigen::Vector3d along = Eigen::Vector3d(1, 2, 2) / 3;
    const Eigen::Matrix3d matrix = 5 * (Eigen::Matrix3d::Identity() - 2 * along * along.transpose());
    EXPECT_TRUE(symmetric_eigenvalues(matrix).isApprox(Eigen::Vector3d(-5, 5, 5), 1e-14));
}

TEST(Symmetric, ZeroMatrixHasZeroEigenvalues) {
    EXPECT_EQ(symmetric_eigenvalues(Eigen::Matrix3d::Zero()), Eigen::VectorXd::Zero(3));
    EXPECT_FALSE(is_positive_definite(Eigen::Matrix3d::Zero()));
}

TEST(Symmetric, StaysPositiveDefiniteUpToMinEigenvalue) {
    for (const Eigen::Index size : {1, 2, 5, 30}) {
        const double min = eigenvalue_of_difference(1, size);
        Eigen::MatrixXd matrix = second_difference(size);
        matrix.diagonal().array() -= min * (1 - 1e-9);
        EXPECT_TRUE(is_positive_definite(matrix)) << size;
        matrix.diagonal().array() -= min * 2e-9;
        EXPECT_FALSE(is_positive_definite(matrix)) << size;
    }
}

TEST(Symmetric, CholeskyReadsOnlyLowerTriangle) {
    Eigen::MatrixXd lower = second_difference(4);
    lower.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
    EXPECT_TRUE(positive_definite_inverse(lower).isApprox(positive_definite_inverse(second_difference(4))));
    EXPECT_TRUE(is_positive_definite(lower));
}

}  // namespace
}  // namespace gsim::base
