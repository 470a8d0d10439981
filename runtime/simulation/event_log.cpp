#include "runtime/simulation/event_log.h"

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

void EventLog::add_before(rrs::TargetId id, Event event) {
    if (!has_room()) return;
    waiting_.push_back({id, events_.size()});
    events_.push_back(std::move(event));
}

void EventLog::take(const motion::Segment& segment, const MoveInfo& info) {
    while (!waiting_.empty() && waiting_.front().id <= info.target_id) {
        events_[waiting_.front().index].t_s = segment.start_s;
        waiting_.pop_front();
    }
}

void EventLog::end_early(double end_s) {
    for (const Waiting& waiting : waiting_)
        events_[waiting.index].t_s = std::numeric_limits<double>::infinity();
    waiting_.clear();
    const auto is_later = [end_s](const Event& event) { return event.t_s > end_s; };
    events_.erase(std::remove_if(events_.begin(), events_.end(), is_later), events_.end());
}

void EventLog::end(double end_s) {
    for (const Waiting& waiting : waiting_) events_[waiting.index].t_s = end_s;
    waiting_.clear();
}

}  // namespace gsim::simulation
