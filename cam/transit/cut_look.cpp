#include "cam/transit/cut_look.h"

#include <set>

#include "runtime/cell/clearance_watch.h"

namespace gsim::transit {

namespace {

motion::Segment straight(const RapidSpace& space, const AxisValues& from, const AxisValues& to,
                         double start_s) {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::linear;
    segment.start = space.machine().joints(from);
    segment.end = space.machine().joints(to);
    segment.start_s = start_s;
    const double length = (segment.end - segment.start).norm();
    segment.lead = motion::TimeLaw::fastest(length, length, motion::kUnlimited);
    segment.duration_s = segment.lead.duration_s();
    return segment;
}

}  // namespace

std::vector<path::Fault> look_at_steps(std::span<const AxisStep> steps, const RapidSpace& space,
                                       const AxisValues& start) {
    cell::ClearanceWatch watch(space.cell(), space.machine().machine());
    std::vector<path::Fault> faults;
    std::set<std::size_t> told;
    AxisValues at = start;
    double time_s = 0;
    for (const AxisStep& step : steps) {
        const motion::Segment segment =
            step.rapid ? space.rapid(at, step.axes) : straight(space, at, step.axes, time_s);
        const std::size_t before = watch.contacts().size();
        watch.take(segment, step.jet_on);
        if (watch.contacts().size() > before && told.insert(step.where.path).second) {
            faults.push_back(
                {step.where, "on the way to " + space.told(step.axes, watch.contacts()[before].pair)});
        }
        time_s += segment.duration_s;
        at = step.axes;
    }
    return faults;
}

}  // namespace gsim::transit
