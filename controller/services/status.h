#pragma once

#include <string_view>

namespace gsim::rrs {

/// Result of a service. 0 is success, a negative value an error that has changed nothing, a positive value a
/// success with additional information. The numbers are stable, because scripts and modules compare them.
enum class Status : int {
    RRS_SUCCESS = 0,
    RRS_NEED_MORE_DATA = 1,          ///< GetNextStep: the queue is empty, the robot is at standstill.
    RRS_TARGET_REACHED = 2,          ///< GetNextStep: this step is the last one of a target.
    RRS_MOTION_TIME_RAISED = 3,      ///< A target: queued, but its limits need more than SetMotionTime asked.
    RRS_NOT_INITIALIZED = -1,        ///< A service other than Initialize before Initialize.
    RRS_SERVICE_NOT_SUPPORTED = -2,  ///< This planner does not offer the service at all.
    RRS_MOTION_TYPE_NOT_SUPPORTED = -3,  ///< The machine or the planner cannot do this type of motion.
    RRS_INVALID_PARAMETER = -4,          ///< A value out of range, not finite, or of the wrong count.
    RRS_NO_INITIAL_POSITION = -5,        ///< A target before SetInitialPosition.
    RRS_NO_SOLUTION = -6,                ///< The inverse kinematics has no solution at all.
    RRS_JOINT_LIMIT = -7,                ///< A joint would leave its range, at the target or on the path.
    RRS_CIRCLE_IMPOSSIBLE = -8,          ///< Via point on the chord, or radii that disagree.
    RRS_MODE_NOT_SUPPORTED = -9,  ///< The service exists, this value of it does not (such as fly-by on).
    RRS_UNKNOWN_FRAME = -10,      ///< No frame of that name in the cell.
    RRS_ZERO_SPEED = -11,         ///< A motion without a programmed speed.
    RRS_QUEUE_FULL = -12,         ///< Too many targets ahead of GetNextStep, and no other consumer.
    RRS_MODULE_FAULT = -13,       ///< The result of a controller module is invalid; then nothing works.
};

/// True if it is an error.
constexpr bool is_error_status(Status status) {
    return static_cast<int>(status) < 0;
}

/// Returns the name of a status as documents and messages write it: "RRS_JOINT_LIMIT".
std::string_view name(Status status);

}  // namespace gsim::rrs
