#include "runtime/simulator/event_log.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gsim::simulation {

namespace {

constexpr std::size_t kMaxEvents = 100'000;

}  // namespace

bool EventLog::has_room() {
    if (events_.size() < kMaxEvents) return true;
    ++dropped_;
    return false;
}

void EventLog::add(double t_s, Event event) {
    if (!has_room()) return;
    event.t_s = t_s;
    events_.push_back(std::move(event));
}

void EventLog::add_before(rrs::TargetId id, Event event, bool with_motion) {
    if (!has_room()) return;
    waiting_.push_back({id, events_.size(), with_motion});
    events_.push_back(std::move(event));
}

void EventLog::take(const motion::Segment& segment, const MoveInfo& info) {
    if (waiting_.empty() || waiting_.front().id > info.target_id) return;
    const auto waits = [&](const Waiting& waiting) {
        if (waiting.id > info.target_id) return true;
        if (waiting.with_motion && info.kind == MoveKind::dwell) return true;
        events_[waiting.index].t_s = segment.start_s;
        return false;
    };
    waiting_.erase(std::stable_partition(waiting_.begin(), waiting_.end(), waits), waiting_.end());
}

/// Removes the events after the end.
void EventLog::erase_later(double end_s) {
    const auto is_later = [end_s](const Event& event) { return event.t_s > end_s; };
    events_.erase(std::remove_if(events_.begin(), events_.end(), is_later), events_.end());
}

void EventLog::end_early(double end_s) {
    for (const Waiting& waiting : waiting_)
        events_[waiting.index].t_s = std::numeric_limits<double>::infinity();
    waiting_.clear();
    erase_later(end_s);
}

void EventLog::end(double end_s) {
    for (const Waiting& waiting : waiting_) {
        events_[waiting.index].t_s = waiting.with_motion ? std::numeric_limits<double>::infinity() : end_s;
    }
    waiting_.clear();
    erase_later(end_s);
}

}  // namespace gsim::simulation
