#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace gsim::rrs {

/// Max number of joints of a robot here; it limits the storage of a JointPos, so that none allocates.
inline constexpr int kMaxJoints = 16;

/// Joint values in the order of the machine's joints: mm for a prismatic joint, rad for a revolute one.
using JointPos = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxJoints, 1>;

/// A Cartesian position: the 4x4 homogeneous matrix of the tool centre point in the selected work frame, mm.
using CartPos = Eigen::Isometry3d;

/// Name that a client gives a target; it is returned with the trajectory.
using TargetId = std::int64_t;

/// Motion of a joint, which sets the unit of its value: mm for a prismatic joint, rad for a revolute one.
enum class JointKind { prismatic, revolute };

enum class MotionType { joint = 1, linear = 2, circular = 4 };
enum class TargetType { cartesian = 0, joint = 1 };

/// Rule that sets the time of a move that changes position and orientation (RRS: dominant interpolation).
/// automatic: the slower of the two; position or orientation: the programmed speed of the other is ignored,
/// and only its joint limits count.
enum class Dominance { automatic = 0, position = 1, orientation = 2 };

/// Mode in which targets are passed: with a stop at each (G61.1, G09), without one only if the path continues
/// straight (G61), or without stops, within a tolerance (G64).
enum class PathMode { exact_stop, exact_path, continuous };

/// Reason why a controller comes to a standstill: its state is queried; it waits for its program's next
/// block; the program has ended.
enum class RestReason { query = 0, wait = 1, end = 2 };

/// Ramps of a motion: as the machine's controller does, straight ramps, S-curves that keep the joints' jerk
/// limits, or none (at once).
enum class RampMode { machine = 0, linear = 1, s_curve = 2, infinite = 3 };

/// Limit of the ramps of a joint.
enum class RampLimit { acceleration = 0, deceleration = 1, jerk = 2 };

/// Role of a target: the end of a motion, or the via point of a circular motion before its end.
enum class TargetParam { end = 0, via = 1 };

}  // namespace gsim::rrs
