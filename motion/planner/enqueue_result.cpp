#include "motion/planner/enqueue_result.h"

#include <fmt/format.h>

namespace gsim::motion {

PlanError motion_time_raised_error(const MotionTimeIncrease& motion_time_increase) {
    return {.status = rrs::Status::RRS_MOTION_TIME_RAISED,
            .message = fmt::format("The move takes {}{} s, not {} s: the machine cannot move faster.",
                                   motion_time_increase.is_lower_bound ? "at least " : "",
                                   motion_time_increase.actual_s, motion_time_increase.requested_s)};
}

std::optional<MotionTimeIncrease> find_raised_time(double actual_s, double requested_s, bool is_lower_bound) {
    if (requested_s <= 0 || actual_s <= requested_s) return std::nullopt;
    return MotionTimeIncrease{actual_s, requested_s, is_lower_bound};
}

}  // namespace gsim::motion
