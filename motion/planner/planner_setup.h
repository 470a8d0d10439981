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
#include "motion/planner/overtravel_log.h"

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
    double max_speed_step = kUnlimited;  ///< Jump of speed that the joint tolerates at a corner.
    double step = 0;                     ///< Smallest step of the joint; 0: none.
    /// Limit for slowing down, if it differs from that for speeding up.
    std::optional<double> max_deceleration = std::nullopt;
    /// Limit set by a program, if MoveLimits replace these limits.
    double programmed_acceleration = kUnlimited;
    double programmed_deceleration = kUnlimited;

    double deceleration() const { return max_deceleration.value_or(max_acceleration); }
    /// Returns the limit of speed changes in both directions.
    double min_acceleration() const { return std::min(max_acceleration, deceleration()); }
};

/// Limits of the tool path, independent of what the joints could do.
struct PathLimits {
    double max_feed_mm_s = kUnlimited;   ///< Max feed of linear and circular moves that are not rapid.
    double max_rapid_mm_s = kUnlimited;  ///< Max speed of rapid moves.
    double max_acceleration_mm_s2 = kUnlimited;        ///< Along the path, in moves that are not rapid.
    double max_rapid_acceleration_mm_s2 = kUnlimited;  ///< Along the path, in rapid moves.
    double max_jerk_mm_s3 = kUnlimited;                ///< Max jerk of LinuxCNC 2.10's planner, in all moves.
};

/// Function of a joint for the tool.
enum class JointRole : unsigned char {
    position,   ///< Carries the TCP along x, y or z of the axis space.
    secondary,  ///< Another prismatic joint.
    rotary,
};

/// Machine data that a planner needs; it does not change during the planner's lifetime.
struct PlannerSetup {
    std::vector<JointSetup> joints;
    PathLimits path;
    rrs::ControllerRules controller;
    /// Prismatic joints with the x, y, z of the TCP in the axis space as their values (except for a rigid
    /// motion of the space); -1 if absent. All -1 means a machine without joints that carry the TCP position
    /// so, which has only joint motion.
    std::array<int, 3> position_joints{-1, -1, -1};
    std::shared_ptr<const kinematics::Kinematics> kinematics;
    /// Max distance of the end of an arc from the circle, across and along it, before the arc is rejected.
    double arc_tolerance_mm = 0.05;
    /// Number of segments that wait before the oldest leaves by itself; at least 2.
    std::size_t queue_capacity = 64;
    /// Optional object that may allow targets past the joint ranges.
    std::shared_ptr<OvertravelLog> overtravel_log;
    /// Operator overrides, on the planner's clock; null: none.
    std::shared_ptr<const OverrideSchedule> overrides;
    /// Source of the joint accelerations for each move; null: they are as in `joints`.
    std::shared_ptr<const MoveLimits> move_limits;

    /// Returns a message about the wrong values, or nullopt if they can be used.
    std::optional<std::string> validate() const;

    int joint_count() const { return static_cast<int>(joints.size()); }
    JointRole role(int joint) const;
    bool has_position_joints() const { return position_joints != std::array{-1, -1, -1}; }
};

}  // namespace gsim::motion
