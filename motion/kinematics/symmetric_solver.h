#pragma once

#include "controller/services/types.h"

namespace gsim::kinematics {

/// Square matrix with a row and a column for each joint.
using JointMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, rrs::kMaxJoints, rrs::kMaxJoints>;

/// Returns the solution of matrix * x = right; the matrix is symmetric and positive definite. Eigen's
/// decompositions take seconds to compile wherever they are used, so this one is in symmetric_solver.cpp.
rrs::JointPos solve_symmetric(const JointMatrix& matrix, const rrs::JointPos& right);

}  // namespace gsim::kinematics
