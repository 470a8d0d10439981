#include "runtime/simulator/event_log.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gsim::simulation {

namespace {

constexpr std::size_t kMaxEvents = 100'000;

}  // namespace

bool EventLog::can_add() {
    if (events_.size() < kMaxEvents) return true;
    ++dropped_;
    return false;
}

void EventLog::add(double t_s, Event event) {
    if (!can_add()) return;
    event.t_s = t_s;
    events_.push_back(std::move(event));
}

void EventLog::add_before(rrs::TargetId id, Event event, bool with_motion) {
    if (!can_add()) return;
    pending_events_.push_back({id, events_.size(), with_motion});
    events_.push_back(std::move(event));
}

void EventLog::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    if (pending_events_.empty() || pending_events_.front().id > info.target_id) return;
    const auto waits = [&](const PendingEvent& pending_event) {
        if (pending_event.id > info.target_id) return true;
        if (pending_event.with_motion && info.kind == MoveKind::dwell) return true;
        events_[pending_event.index].t_s = segment.start_s;
        return false;
    };
    pending_events_.erase(std::stable_partition(pending_events_.begin(), pending_events_.end(), waits),
                          pending_events_.end());
}

/// Removes the events after the end.
void EventLog::erase_after(double end_s) {
    const auto is_later = [end_s](const Event& event) { return event.t_s > end_s; };
    events_.erase(std::remove_if(events_.begin(), events_.end(), is_later), events_.end());
}

void EventLog::truncate(double end_s) {
    for (const PendingEvent& pending_event : pending_events_)
        events_[pending_event.index].t_s = std::numeric_limits<double>::infinity();
    pending_events_.clear();
    erase_after(end_s);
}

void EventLog::end(double end_s) {
    for (const PendingEvent& pending_event : pending_events_) {
        events_[pending_event.index].t_s =
            pending_event.with_motion ? std::numeric_limits<double>::infinity() : end_s;
    }
    pending_events_.clear();
    erase_after(end_s);
}

}  // namespace gsim::simulation
