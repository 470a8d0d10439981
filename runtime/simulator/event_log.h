#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// Events of a run with their times. An event that does not stop the machine happens when the next move
/// begins. That time is known only once that move has been planned.
class EventLog final : public RunOutput {
  public:
    /// Adds an event at a known time.
    void add(double t_s, Event event);
    /// Adds an event that happens when the move with this target id, or a later one, begins; else at the end
    /// of the run. `with_motion`: dwells do not count as such a move, and without a move the event never
    /// happens.
    void add_before(rrs::TargetId id, Event event, bool with_motion = false);

    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// Ends the machine's motion at this time; later events never happen.
    void truncate(double end_s);

    std::vector<Event> release() { return std::move(events_); }
    /// Returns the number of events beyond the maximum that a report lists.
    std::uint64_t dropped() const { return dropped_; }

  private:
    struct PendingEvent {
        rrs::TargetId id;
        std::size_t index;  ///< In events_.
        bool with_motion;
    };

    bool can_add();
    void erase_after(double end_s);

    std::vector<Event> events_;
    std::deque<PendingEvent> pending_events_;  ///< In the order of their ids.
    std::uint64_t dropped_ = 0;
};

}  // namespace gsim::simulation
