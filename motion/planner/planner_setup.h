#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/services/controller_rules.h"
#include "controller/services/types.h"
#include "motion/kinematics/kinematics.h"
#include "motion/planner/override_schedule.h"
#include "motion/planner/range_notes.h"

namespace gsim::motion {

class MoveLimits;

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// One joint as the planner sees it. Units are mm or rad by kind.
struct JointSetup {
    rrs::JointKind kind = rrs::JointKind::prismatic;
    double min = -kUnlimited;
    double max = kUnlimited;
    double max_speed = kUnlimited;
    double max_acceleration = kUnlimited;
    double max_jerk = kUnlimited;
    double max_speed_step = kUnlimited;  ///< Jump of speed that the joint stands at a corner.
    double step = 0;                     ///< Smallest step of the joint; 0: none.
    /// For slowing down, where it is another limit than that for speeding up.
    std::optional<double> max_deceleration = std::nullopt;
    /// What a program allows, where MoveLimits put others in the place of these limits.
    double programmed_acceleration = kUnlimited;
    double programmed_deceleration = kUnlimited;

    double deceleration() const { return max_deceleration.value_or(max_acceleration); }
    /// What limits changes of speed both ways.
    double least_acceleration() const { return std::min(max_acceleration, deceleration()); }
};

/// Limits of the tool's path, whatever the joints could do.
struct PathLimits {
    double max_feed_mm_s = kUnlimited;                 ///< Of linear and circular moves that are not rapid.
    double max_rapid_mm_s = kUnlimited;                ///< Of rapid moves.
    double max_acceleration_mm_s2 = kUnlimited;        ///< Along the path, in moves that are not rapid.
    double max_rapid_acceleration_mm_s2 = kUnlimited;  ///< Along the path, in rapid moves.
    double max_jerk_mm_s3 = kUnlimited;                ///< Of the planner of LinuxCNC 2.10, in all moves.
};

/// What a joint does for the tool.
enum class JointRole : unsigned char {
    position,   ///< Carries the tool tip along x, y or z of the axis space.
    secondary,  ///< Another prismatic joint.
    rotary,
};

/// All that a planner has to know of a machine; it does not change while the planner lives.
struct PlannerSetup {
    std::vector<JointSetup> joints;
    PathLimits path;
    rrs::ControllerRules controller;
    /// The prismatic joints whose values are x, y, z of the tool tip in the axis space (but for a rigid
    /// motion of the space); -1 where absent. All -1: a machine whose tip position is not carried by joints
    /// so, which has joint motion alone.
    std::array<int, 3> position_joints{-1, -1, -1};
    std::shared_ptr<const kinematics::Kinematics> kinematics;
    /// How far the end of an arc may lie off the circle, across and along it, before the arc is refused.
    double arc_tolerance_mm = 0.05;
    /// Segments that wait before the oldest leaves by itself; at least 2.
    std::size_t queue_capacity = 64;
    /// Where set, it may let targets past the joints' ranges through.
    std::shared_ptr<RangeNotes> range_notes;
    /// What the operator turns the overrides to, on the planner's clock; null: nothing.
    std::shared_ptr<const OverrideSchedule> overrides;
    /// What sets the accelerations of the joints for each move; null: they are as `joints` has them.
    std::shared_ptr<const MoveLimits> move_limits;

    /// What is wrong with the values, as a sentence; nothing where they can be used.
    std::optional<std::string> validate() const;

    int joint_count() const { return static_cast<int>(joints.size()); }
    JointRole role(int joint) const;
    bool has_position_joints() const { return position_joints != std::array{-1, -1, -1}; }
};

}  // namespace gsim::motion
