#include "runtime/script/words/program_frame.h"

#include <Eigen/LU>
#include <cmath>

namespace gsim::script {

using simulation::AxisVector;

namespace {

constexpr double kMinDeterminant = 1e-12;

}  // namespace

ProgramFrame::ProgramFrame(std::size_t axis_count, const std::array<int, 3>& xyz_axes)
    : xyz_axes_(xyz_axes), offset_(AxisVector::Zero(static_cast<Eigen::Index>(axis_count))) {}

bool ProgramFrame::set_matrix(const std::optional<Eigen::Matrix3d>& matrix) {
    if (!matrix) {
        matrix_.reset();
        return true;
    }
    const double determinant = matrix->determinant();
    if (!std::isfinite(determinant) || std::abs(determinant) < kMinDeterminant) return false;
    matrix_ = matrix;
    inverse_ = matrix->inverse();
    return true;
}

Eigen::Vector3d ProgramFrame::xyz(const AxisVector& values) const {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int axis = xyz_axes_[static_cast<std::size_t>(i)];
        if (axis >= 0) point[i] = values[axis];
    }
    return point;
}

void ProgramFrame::set_xyz(AxisVector& values, const Eigen::Vector3d& point) const {
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int axis = xyz_axes_[static_cast<std::size_t>(i)];
        if (axis >= 0) values[axis] = point[i];
    }
}

Eigen::Vector3d ProgramFrame::direction(const Eigen::Vector3d& program) const {
    return matrix_ ? Eigen::Vector3d(*matrix_ * program) : program;
}

AxisVector ProgramFrame::to_machine(AxisVector program) const {
    if (matrix_) set_xyz(program, *matrix_ * xyz(program));
    return program + offset_;
}

AxisVector ProgramFrame::to_program(AxisVector machine) const {
    machine -= offset_;
    if (matrix_) set_xyz(machine, inverse_ * xyz(machine));
    return machine;
}

}  // namespace gsim::script
