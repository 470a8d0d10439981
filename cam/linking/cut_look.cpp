#include "cam/linking/cut_look.h"

#include <set>

#include "collision/monitor/clearance_watch.h"

namespace gsim::transit {

std::vector<path::Fault> look_at_steps(std::span<const AxisStep> steps, const RapidSpace& space,
                                       const AxisValues& start) {
    cell::ClearanceWatch watch(space.cell(), space.machine().machine());
    std::vector<path::Fault> faults;
    std::set<std::size_t> told;
    AxisValues at = start;
    for (const AxisStep& step : steps) {
        const motion::Segment segment =
            step.rapid ? space.rapid(at, step.axes) : space.straight(at, step.axes);
        const std::size_t before = watch.contacts().size();
        watch.take(segment, step.jet_on);
        if (watch.contacts().size() > before && told.insert(step.where.path).second) {
            faults.push_back(
                {step.where, "on the way to " + space.told(step.axes, watch.contacts()[before].pair)});
        }
        at = step.axes;
    }
    return faults;
}

}  // namespace gsim::transit
