#include "runtime/simulator/program/program_events.h"

#include <utility>

namespace gsim::simulation {

ProgramEvents::ProgramEvents(MachineMotion& motion, const ProgramPosition& position, const TargetIds& ids,
                             const ProgramNotifier& notifier)
    : motion_(motion), position_(position), ids_(ids), notifier_(notifier) {
    motion.recorder().add_output(log_);
}

void ProgramEvents::add(std::string kind, std::string detail, const SourceLocation& location,
                        EventTiming timing) {
    Event event{.location = location, .kind = std::move(kind), .detail = std::move(detail)};
    notifier_.notify([&](ProgramObserver& observer) {
        observer.event(position_.axes(), event, timing == EventTiming::at_standstill);
    });
    if (timing != EventTiming::at_standstill)
        return log_.add_before(ids_.next(), std::move(event), timing == EventTiming::with_motion);
    motion_.source().plan_to_standstill(true);
    log_.add(motion_.source().time_s(), std::move(event));
}

}  // namespace gsim::simulation
