#include "motion/planner/enqueue_result.h"

#include <fmt/format.h>

namespace gsim::motion {

PlanError time_raised(const TimeRaised& raised_time) {
    return {.status = rrs::Status::RRS_MOTION_TIME_RAISED,
            .message = fmt::format("The move takes {}{} s, not {} s: the machine cannot move faster.",
                                   raised_time.at_least ? "at least " : "", raised_time.actual_s,
                                   raised_time.requested_s)};
}

std::optional<TimeRaised> find_raised_time(double actual_s, double requested_s, bool at_least) {
    if (requested_s <= 0 || actual_s <= requested_s) return std::nullopt;
    return TimeRaised{actual_s, requested_s, at_least};
}

}  // namespace gsim::motion
