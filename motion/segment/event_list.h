#pragma once

#include <optional>
#include <vector>

#include "controller/services/types.h"
#include "motion/planner/pending_targets.h"
#include "motion/segment/segment_queue.h"

namespace gsim::motion {

/// Distance between reaching the target and the event; negative: before.
struct EventOffset {
    enum class Measure { time_s, distance_mm } measure = Measure::time_s;
    double value = 0;
};

/// Events that a client has defined, and those that occurred in the last step.
class EventList {
  public:
    struct TriggeredEvent {
        int id;
        double time_s;  ///< Time since the start of the step; negative if it was before that.
    };

    /// Defines an event, which replaces one with the same id.
    void define(int id, rrs::TargetId target, EventOffset offset);
    /// Cancels an event. Returns false if no such event is pending.
    bool cancel(int id);
    void clear();

    /// Returns the time until which only known events can occur, if events before targets in `pending`
    /// exist. `end_s` is the end of the queue.
    std::optional<double> known_until_s(const PendingTargets& pending, const SegmentQueue& queue,
                                        double end_s) const;
    /// Finds the events that occur in a step of the clock. `queue` has the segments that are active in it and
    /// the next ones, as far as they are known. An event that occurred before the step but was not known then
    /// keeps its time. It has the step's start if its time is not known any more either.
    void step(double from_s, double to_s, const SegmentQueue& queue);
    /// Notes that the front segment is about to leave the queue.
    void leave(const SegmentQueue& queue);
    /// Notes that a target without its own motion is reached with another one, or at a time.
    void join(rrs::TargetId target, rrs::TargetId with);
    void reach(rrs::TargetId target, double at_s);

    /// Returns the events of the last step, in the order of time.
    const std::vector<TriggeredEvent>& triggered_events() const { return triggered_events_; }

  private:
    struct Event {
        int id;
        rrs::TargetId target;
        EventOffset offset;               ///< A distance past a target that has been reached: its remainder.
        std::optional<double> reached_s;  ///< When its target was reached, if its motion has left the queue.
        std::optional<double> at_s;       ///< When it came true, if that has left the queue.
    };

    static std::optional<double> event_time_s(const Event& event, const SegmentQueue& queue);

    std::vector<Event> events_;
    std::vector<TriggeredEvent> triggered_events_;
};

}  // namespace gsim::motion
