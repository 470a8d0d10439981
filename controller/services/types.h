#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace gsim::rrs {

/// The most joints a robot may have here; it bounds the storage of a JointPos, so that none allocates.
inline constexpr int kMaxJoints = 16;

/// Joint values in the order of the machine's joints: mm for a prismatic joint, rad for a revolute one.
using JointPos = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxJoints, 1>;

/// A Cartesian position: the 4x4 homogeneous matrix of the tool centre point in the selected work frame, mm.
using CartPos = Eigen::Isometry3d;

/// A client's name for a target; it comes back with the trajectory.
using TargetId = std::int64_t;

/// How a joint moves, and so the unit of its value: mm for a prismatic joint, rad for a revolute one.
enum class JointKind { prismatic, revolute };

enum class MotionType { joint = 1, linear = 2, circular = 4 };
enum class TargetType { cartesian = 0, joint = 1 };

/// Which rule sets the time of a move that changes position and orientation (RRS: dominant interpolation).
/// automatic: the slower of the two; position or orientation: the programmed speed of the other is not
/// looked at, only its joint limits.
enum class Dominance { automatic = 0, position = 1, orientation = 2 };

/// How targets are passed: with a stop at each (G61.1, G09), without one only where the path goes on straight
/// (G61), or without stops, within a tolerance (G64).
enum class PathMode { exact_stop, exact_path, continuous };

/// Why a controller comes to rest: its state is asked for; it waits for its program's next block; the program
/// has ended.
enum class RestReason { query = 0, wait = 1, end = 2 };

/// How motion speeds up and slows down: as the machine's controller does, with straight ramps, with S-curves
/// that keep the joints' jerk limits, or at once.
enum class RampMode { machine = 0, linear = 1, s_curve = 2, infinite = 3 };

/// What limits the ramps of a joint.
enum class RampLimit { acceleration = 0, deceleration = 1, jerk = 2 };

/// What a target is: the end of a motion, or the via point of the circular motion whose end follows.
enum class TargetParam { end = 0, via = 1 };

}  // namespace gsim::rrs
