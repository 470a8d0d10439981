#include "motion/kinematics/symmetric_solver.h"

#include <Eigen/Cholesky>

namespace gsim::kinematics {

rrs::JointPos solve_symmetric(const JointMatrix& matrix, const rrs::JointPos& right) {
    return matrix.ldlt().solve(right);
}

}  // namespace gsim::kinematics
