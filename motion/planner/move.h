#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/services/types.h"
#include "motion/planner/move_parameters.h"

namespace gsim::motion {

/// Circle about an axis: counter-clockwise about the unit vector `axis` by `sweep_rad` > 0 in all, and along
/// it as far as the goal requires.
struct Circle {
    Eigen::Vector3d center_mm;  ///< Any point of the axis.
    Eigen::Vector3d axis;
    double sweep_rad = 0;
};

/// Joint that the inverse keeps at its value, and the value to which the program moves it (groups of axes).
struct GroupJoint {
    int joint = 0;
    double value = 0;          ///< mm or rad, at the end of the move.
    bool coordinated = false;  ///< True if the tool path is one on the work meanwhile; see GroupPath.
};

/// Target pose of a frame that the tool carries.
struct PoseGoal {
    rrs::CartPos pose;  ///< In the work frame.
    rrs::CartPos tool;  ///< The frame, in that of the tool centre point.
    /// Joints that the inverse holds (Kinematics::fixed_joints()) and that move to other values.
    std::vector<GroupJoint> group_joints = {};

    rrs::CartPos tcp_pose() const;
};

/// Target position of the machine: a pose if set, otherwise joint values.
struct Goal {
    rrs::JointPos joints;  ///< mm or rad
    std::optional<PoseGoal> pose;
};

/// Complete move as a program requests it: a planner that gets it has to remember only the end of the ones
/// before.
struct Move {
    rrs::TargetId target_id = 0;
    rrs::MotionType type = rrs::MotionType::linear;
    Goal goal;
    std::optional<Goal> via;  ///< A point of a circular move
    /// or its circle: in the space of the position joints x, y and z; for a pose or a controlled point in the
    /// work frame.
    std::optional<Circle> circle;
    /// TCP control: the point that follows the path, in the frame of the tool centre point.
    std::optional<Eigen::Vector3d> tcp_mm;
    MoveParameters move_parameters;
    double dwell_s = 0;  ///< Dwell that follows, with the same id.
};

}  // namespace gsim::motion
