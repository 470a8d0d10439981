#pragma once

#include <functional>
#include <optional>

#include <tl/expected.hpp>

#include "motion/planner/plan_error.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Function that checks a segment and returns the instant on the planner's clock at which its motion is to be
/// stopped, if any.
using StopSearch = std::function<std::optional<double>(const Segment&)>;

/// Note that an enqueued move takes longer than requested: the machine can do it no faster.
struct MotionTimeIncrease {
    double actual_s = 0;
    double requested_s = 0;
    bool is_lower_bound = false;  ///< True if the time is only known from the following moves.
};

/// Returns the same as a result: RRS_MOTION_TIME_RAISED and a message.
PlanError motion_time_raised_error(const MotionTimeIncrease& motion_time_increase);

/// Returns the note if a move takes longer than requested; nullopt if no time was requested (0).
std::optional<MotionTimeIncrease> find_raised_time(double actual_s, double requested_s, bool is_lower_bound);

/// Result of an enqueued move; an error leaves everything unchanged.
using EnqueueResult = tl::expected<std::optional<MotionTimeIncrease>, PlanError>;

}  // namespace gsim::motion
