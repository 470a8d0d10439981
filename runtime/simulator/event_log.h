#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// The events of a run, with the times at which they happen. An event that does not stop the machine happens
/// when the move behind it begins, which is known only when that move has been planned.
class EventLog final : public RunOutput {
  public:
    /// Something that happens at a known time.
    void add(double t_s, Event event);
    /// Something that happens when the move with this target id, or one behind it, begins; else at the end of
    /// the run. `with_motion`: dwells are no such move, and without one it never happens.
    void add_before(rrs::TargetId id, Event event, bool with_motion = false);

    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// The machine goes on no further than to this time: what would happen later never does.
    void end_early(double end_s);

    std::vector<Event> release() { return std::move(events_); }
    /// Events past the most that a report lists.
    std::uint64_t dropped() const { return dropped_; }

  private:
    struct Waiting {
        rrs::TargetId id;
        std::size_t index;  ///< In events_.
        bool with_motion;
    };

    bool has_room();
    void erase_later(double end_s);

    std::vector<Event> events_;
    std::deque<Waiting> waiting_;  ///< In the order of their ids.
    std::uint64_t dropped_ = 0;
};

}  // namespace gsim::simulation
