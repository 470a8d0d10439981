#include "runtime/motion/event_list.h"

#include <algorithm>
#include <limits>

namespace gsim::motion {

namespace {

constexpr double kPast_s = -std::numeric_limits<double>::infinity();

/// When a segment has gone `way_mm`, by bisection: laws never run back.
double time_at(const Segment& segment, double way_mm) {
    const double way = way_mm * segment.lead.length() / segment.length_mm;
    double low = 0;
    double high = segment.duration_s;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (segment.lead.at(middle).s < way ? low : high) = middle;
    }
    return segment.start_s + high;
}

/// Index of the segment that ends at the target, if it is known.
std::optional<std::size_t> end_of(rrs::TargetId target, const SegmentQueue& queue) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        if (queue[i].target_id == target && queue[i].reaches_target)
            found = i;
        else if (found)
            break;
    }
    return found;
}

std::optional<double> time_behind(double way_mm, std::size_t index, const SegmentQueue& queue) {
    for (; index < queue.size(); ++index) {
        const Segment& segment = queue[index];
        if (segment.length_mm > 0 && way_mm <= segment.length_mm) return time_at(segment, way_mm);
        way_mm -= segment.length_mm;
    }
    return std::nullopt;
}

/// Back from the end of a segment.
double time_before(double way_mm, std::size_t index, const SegmentQueue& queue) {
    for (std::size_t i = index + 1; i-- > 0;) {
        const Segment& segment = queue[i];
        if (segment.length_mm > 0 && way_mm <= segment.length_mm)
            return time_at(segment, segment.length_mm - way_mm);
        way_mm -= segment.length_mm;
    }
    return kPast_s;
}

}  // namespace

void EventList::define(int id, rrs::TargetId target, EventOffset offset) {
    cancel(id);
    events_.push_back({id, target, offset, std::nullopt});
}

bool EventList::cancel(int id) {
    return std::erase_if(events_, [id](const Event& event) { return event.id == id; }) > 0;
}

void EventList::clear() {
    events_.clear();
    came_true_.clear();
}

void EventList::step(double from_s, double to_s, const SegmentQueue& queue) {
    came_true_.clear();
    std::erase_if(events_, [&](const Event& event) {
        const std::optional<double> at_s = time_of(event, queue);
        if (!at_s || *at_s > to_s) return false;
        came_true_.push_back({event.id, std::max(*at_s - from_s, 0.0)});
        return true;
    });
    std::stable_sort(came_true_.begin(), came_true_.end(),
                     [](const CameTrue& a, const CameTrue& b) { return a.time_s < b.time_s; });
}

std::optional<double> EventList::time_of(const Event& event, const SegmentQueue& queue) {
    const double offset = event.offset.value;
    const bool by_time = event.offset.measure == EventOffset::Measure::time_s;
    if (event.reached_s) {
        if (by_time) return *event.reached_s + offset;
        return offset > 0 ? time_behind(offset, 0, queue) : kPast_s;
    }
    const std::optional<std::size_t> end = end_of(event.target, queue);
    if (!end) return std::nullopt;
    if (by_time || offset == 0) return queue[*end].end_s() + offset;
    return offset < 0 ? time_before(-offset, *end, queue) : time_behind(offset, *end + 1, queue);
}

void EventList::leave(const Segment& segment) {
    for (Event& event : events_) {
        if (event.reached_s && event.offset.measure == EventOffset::Measure::way_mm) {
            event.offset.value -= segment.length_mm;
        } else if (!event.reached_s && event.target == segment.target_id && segment.reaches_target) {
            event.reached_s = segment.end_s();
        }
    }
}

}  // namespace gsim::motion
