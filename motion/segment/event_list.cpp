#include "motion/segment/event_list.h"

#include <algorithm>
#include <limits>

#include "motion/exact_stop/uncoordinated_move.h"

namespace gsim::motion {

namespace {

constexpr double kPast_s = -std::numeric_limits<double>::infinity();

/// Returns the time at which a segment has covered `distance_mm`, by bisection: laws never run back.
double time_at_distance(const Segment& segment, double distance_mm) {
    if (segment.is_uncoordinated()) return segment.start_s + uncoordinated_time_s(segment, distance_mm);
    const double distance = distance_mm * segment.master.length() / segment.length_mm;
    double low = 0;
    double high = segment.duration_s;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (segment.master.at(middle).s < distance ? low : high) = middle;
    }
    return segment.start_s + high;
}

/// Returns the index of the segment that ends at the target, if it is known. A dwell that follows has the
/// same id.
std::optional<std::size_t> find_end_segment(rrs::TargetId target, const SegmentQueue& queue) {
    for (std::size_t i = 0; i < queue.size(); ++i) {
        if (queue[i].target_id == target && queue[i].reaches_target) return i;
    }
    return std::nullopt;
}

std::optional<double> time_after_distance(double distance_mm, std::size_t index, const SegmentQueue& queue) {
    for (; index < queue.size(); ++index) {
        const Segment& segment = queue[index];
        if (segment.length_mm > 0 && distance_mm <= segment.length_mm)
            return time_at_distance(segment, distance_mm);
        distance_mm -= segment.length_mm;
    }
    return std::nullopt;
}

/// Counts back from the end of a segment.
double time_before_distance(double distance_mm, std::size_t index, const SegmentQueue& queue) {
    for (std::size_t i = index + 1; i-- > 0;) {
        const Segment& segment = queue[i];
        if (segment.length_mm > 0 && distance_mm <= segment.length_mm)
            return time_at_distance(segment, segment.length_mm - distance_mm);
        distance_mm -= segment.length_mm;
    }
    return kPast_s;
}

}  // namespace

void EventList::define(int id, rrs::TargetId target, EventOffset offset) {
    cancel(id);
    events_.push_back({id, target, offset, std::nullopt, std::nullopt});
}

bool EventList::cancel(int id) {
    return std::erase_if(events_, [id](const Event& event) { return event.id == id; }) > 0;
}

void EventList::clear() {
    events_.clear();
    triggered_events_.clear();
}

void EventList::step(double from_s, double to_s, const SegmentQueue& queue) {
    triggered_events_.clear();
    std::erase_if(events_, [&](const Event& event) {
        const std::optional<double> at_s = event_time_s(event, queue);
        if (!at_s || *at_s > to_s) return false;
        triggered_events_.push_back({event.id, *at_s == kPast_s ? 0 : *at_s - from_s});
        return true;
    });
    std::stable_sort(triggered_events_.begin(), triggered_events_.end(),
                     [](const TriggeredEvent& a, const TriggeredEvent& b) { return a.time_s < b.time_s; });
}

std::optional<double> EventList::known_until_s(const PendingTargets& pending, const SegmentQueue& queue,
                                               double end_s) const {
    std::optional<double> known_s;
    for (const Event& event : events_) {
        const double offset = event.offset.value;
        if (offset >= 0 || event.reached_s || !pending.has(event.target)) continue;
        double until_s = end_s + offset;
        if (event.offset.measure == EventOffset::Measure::distance_mm)
            until_s = queue.empty() ? kPast_s : time_before_distance(-offset, queue.size() - 1, queue);
        known_s = std::min(known_s.value_or(until_s), until_s);
    }
    return known_s;
}

std::optional<double> EventList::event_time_s(const Event& event, const SegmentQueue& queue) {
    if (event.at_s) return event.at_s;
    const double offset = event.offset.value;
    const bool over_time = event.offset.measure == EventOffset::Measure::time_s;
    if (event.reached_s) {
        if (over_time) return *event.reached_s + offset;
        return offset > 0 ? time_after_distance(offset, 0, queue) : kPast_s;
    }
    const std::optional<std::size_t> end = find_end_segment(event.target, queue);
    if (!end) return std::nullopt;
    if (over_time || offset == 0) return queue[*end].end_s() + offset;
    return offset < 0 ? time_before_distance(-offset, *end, queue)
                      : time_after_distance(offset, *end + 1, queue);
}

void EventList::leave(const SegmentQueue& queue) {
    const Segment& segment = queue.front();
    for (Event& event : events_) {
        const std::optional<double> at_s = event_time_s(event, queue);
        if (at_s && *at_s > kPast_s && *at_s <= segment.end_s()) event.at_s = at_s;
        if (event.reached_s && event.offset.measure == EventOffset::Measure::distance_mm) {
            event.offset.value -= segment.length_mm;
        } else if (!event.reached_s && event.target == segment.target_id && segment.reaches_target) {
            event.reached_s = segment.end_s();
        }
    }
}

void EventList::join(rrs::TargetId target, rrs::TargetId with) {
    for (Event& event : events_) {
        if (event.target == target && !event.reached_s) event.target = with;
    }
}

void EventList::reach(rrs::TargetId target, double at_s) {
    for (Event& event : events_) {
        if (event.target == target && !event.reached_s) event.reached_s = at_s;
    }
}

}  // namespace gsim::motion
