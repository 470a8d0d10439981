#pragma once

#include <optional>
#include <vector>

#include "controller/services/types.h"
#include "motion/planner/held_targets.h"
#include "motion/segment/segment_queue.h"

namespace gsim::motion {

/// How far from reaching its target an event comes true; negative: before.
struct EventOffset {
    enum class Measure { time_s, way_mm } measure = Measure::time_s;
    double value = 0;
};

/// Events that a client has defined, and those that came true in the last step.
class EventList {
  public:
    struct CameTrue {
        int id;
        double time_s;  ///< Since the start of the step; negative where that long before it.
    };

    /// In place of an event of the same id.
    void define(int id, rrs::TargetId target, EventOffset offset);
    /// False where there is no such event that has yet to come true.
    bool cancel(int id);
    void clear();

    /// The time until which no event can come true but those that are known, where there are events before
    /// targets that are `held`. `end_s` is the end of the queue.
    std::optional<double> known_until_s(const HeldTargets& held, const SegmentQueue& queue,
                                        double end_s) const;
    /// Finds what comes true in a step of the clock; `queue` has the segments that are under way in it and
    /// those behind, as far as they are known. What came true before the step but was not known then keeps
    /// its time; where that is not known any more either it is the step's start.
    void step(double from_s, double to_s, const SegmentQueue& queue);
    /// The front segment is about to leave the queue.
    void leave(const SegmentQueue& queue);
    /// A target that had no motion of its own is reached with another one, or at a time.
    void join(rrs::TargetId target, rrs::TargetId with);
    void reach(rrs::TargetId target, double at_s);

    /// In the last step, in the order of time.
    const std::vector<CameTrue>& came_true() const { return came_true_; }

  private:
    struct Event {
        int id;
        rrs::TargetId target;
        EventOffset offset;  ///< A way behind a target that has been reached: what is left of it.
        std::optional<double> reached_s;  ///< When its target was reached, if its motion has left the queue.
        std::optional<double> at_s;       ///< When it came true, if that has left the queue.
    };

    static std::optional<double> time_of(const Event& event, const SegmentQueue& queue);

    std::vector<Event> events_;
    std::vector<CameTrue> came_true_;
};

}  // namespace gsim::motion
