#pragma once

#include "motion/planner/plan_error.h"
#include "motion/segment/event_list.h"

namespace gsim::motion {

/// Services for the events at an offset from reaching a target. Each service function does the same as the
/// service of its name. It requires Initialize.
class EventServices {
  public:
    /// Makes the services for a planner's events, which must outlive them.
    explicit EventServices(EventList& events) : events_(events) {}

    /// Defines an event by time or by distance.
    PlanResult define_event(int event_id, rrs::TargetId target, EventOffset offset);
    PlanResult cancel_event(int event_id);
    PlanResult get_event(int number, int& event_id, double& time_s) const;

  private:
    EventList& events_;
};

}  // namespace gsim::motion
