#include "base/dense/singular.h"

#include <Eigen/SVD>
#include <algorithm>

namespace gsim::base {

// The matrix is padded with zeros to a square, because Eigen's code for other matrices adds seven seconds to
// each build. The iteration does not change rows and columns of zeros, so each added direction comes back as
// it was and is omitted.
SingularValues singular_values(const Eigen::MatrixXd& matrix) {
    const Eigen::Index size = std::max(matrix.rows(), matrix.cols());
    const Eigen::Index count = std::min(matrix.rows(), matrix.cols());
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(size, size);
    square.topLeftCorner(matrix.rows(), matrix.cols()) = matrix;
    const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(square, Eigen::ComputeFullV);

    SingularValues result{Eigen::VectorXd(count), Eigen::MatrixXd(matrix.cols(), count)};
    Eigen::Index found = 0;
    for (Eigen::Index i = 0; i < size && found < count; ++i) {
        const auto direction = svd.matrixV().col(i).head(matrix.cols());
        if (direction.squaredNorm() < 0.5) continue;
        result.values[found] = svd.singularValues()[i];
        result.right.col(found++) = direction;
    }
    return result;
}

}  // namespace gsim::base
