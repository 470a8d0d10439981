#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/services/types.h"
#include "motion/planner/move_terms.h"

namespace gsim::motion {

/// A circle about an axis: counter-clockwise about the unit vector `axis` by `sweep_rad` > 0 in all, and
/// along it as far as the goal asks.
struct Circle {
    Eigen::Vector3d center_mm;  ///< Any point of the axis.
    Eigen::Vector3d axis;
    double sweep_rad = 0;
};

/// A joint that the inverse leaves where it is, and where the program leads it (groups of axes).
struct LedJoint {
    int joint = 0;
    double value = 0;          ///< mm or rad, at the end of the move.
    bool coordinated = false;  ///< The tool's way is one on the work meanwhile; see LedWay.
};

/// A frame that the tool carries is to be at a pose.
struct PoseGoal {
    rrs::CartPos pose;  ///< In the work frame.
    rrs::CartPos tool;  ///< The frame, in that of the tool centre point.
    /// Of the joints that the inverse holds (Kinematics::held_joints()) those that go elsewhere.
    std::vector<LedJoint> led = {};

    rrs::CartPos tool_centre() const;
};

/// A place for the machine: a pose where there is one, else joint values.
struct Goal {
    rrs::JointPos joints;  ///< mm or rad
    std::optional<PoseGoal> pose;
};

/// A move as a program asks for it, whole: a planner that gets it needs to remember nothing of the ones
/// before but where they ended.
struct Move {
    rrs::TargetId target_id = 0;
    rrs::MotionType type = rrs::MotionType::linear;
    Goal goal;
    std::optional<Goal> via;  ///< A point of a circular move
    /// or its circle: in the space of the position joints x, y and z, for a pose or a tip in the work frame.
    std::optional<Circle> circle;
    /// Tool-centre-point control: the point that goes the way, in the frame of the tool centre point.
    std::optional<Eigen::Vector3d> tip_mm;
    MoveTerms terms;
    double rest_s = 0;  ///< Dwell behind it, by the same id.
};

}  // namespace gsim::motion
