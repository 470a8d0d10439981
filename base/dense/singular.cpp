#include "base/dense/singular.h"

#include <Eigen/SVD>
#include <algorithm>

namespace gsim::base {

// The matrix is made square with zeros, since Eigen's way to take other ones costs seven seconds of each
// build. The iteration leaves rows and columns of zeros alone, so each direction that was added comes back as
// it was and is left out.
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
