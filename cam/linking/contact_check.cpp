#include "cam/linking/contact_check.h"

#include <set>

#include "collision/monitor/clearance_monitor.h"

namespace gsim::linking {

std::vector<path::TargetError> check_contacts(std::span<const AxisStep> steps, const RapidPlanner& space,
                                              const AxisValues& start) {
    cell::ClearanceMonitor monitor(space.cell(), space.machine().machine());
    std::vector<path::TargetError> errors;
    std::set<std::size_t> reported;
    AxisValues at = start;
    for (const AxisStep& step : steps) {
        const motion::Segment segment =
            step.rapid ? space.rapid(at, step.axes) : space.straight_segment(at, step.axes);
        const std::size_t before = monitor.contacts().size();
        monitor.on_segment(segment, step.process_on);
        if (monitor.contacts().size() > before && reported.insert(step.where.path).second) {
            errors.push_back(
                {step.where,
                 "on the path to " + space.collision_text(step.axes, monitor.contacts()[before].pair)});
        }
        at = step.axes;
    }
    return errors;
}

}  // namespace gsim::linking
