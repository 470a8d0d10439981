#include "motion/services/event_services.h"

#include <cmath>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::Status;

PlanResult EventServices::define_event(int event_id, rrs::TargetId target, EventOffset offset) {
    if (!std::isfinite(offset.value)) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The offset of event {} is not finite.", event_id));
    }
    events_.define(event_id, target, offset);
    return {};
}

PlanResult EventServices::cancel_event(int event_id) {
    if (events_.cancel(event_id)) return {};
    return make_plan_error(Status::RRS_INVALID_PARAMETER, fmt::format("Event {} is not pending.", event_id));
}

PlanResult EventServices::get_event(int number, int& event_id, double& time_s) const {
    const std::vector<EventList::TriggeredEvent>& events = events_.triggered_events();
    if (number < 0 || static_cast<std::size_t>(number) >= events.size()) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Event {} does not exist; {} occurred in the last step.", number, events.size()));
    }
    event_id = events[static_cast<std::size_t>(number)].id;
    time_s = events[static_cast<std::size_t>(number)].time_s;
    return {};
}

}  // namespace gsim::motion
