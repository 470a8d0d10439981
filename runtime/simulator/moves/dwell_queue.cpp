#include "runtime/simulator/moves/dwell_queue.h"

#include <utility>

namespace gsim::simulation {

motion::EnqueueResult DwellQueue::enqueue(const DwellRequest& request) {
    const motion::PlanResult planned = motion_.source().enqueue_dwell(request);
    if (!planned) return tl::unexpected(planned.error());
    return {};
}

bool DwellQueue::enqueue(double seconds, const SourceLocation& location) {
    const MoveInfo info = program_.make_info(MoveKind::dwell, location, 0);
    motion_.recorder().expect(info);
    const motion::EnqueueResult enqueued = enqueue({info.target_id, seconds, {}});
    if (enqueued)
        notifier_.notify([&](ProgramObserver& observer) { observer.dwell(position_.axes(), seconds); });
    return acceptance_.finish(enqueued, location);
}

bool DwellQueue::enqueue_for_word(double seconds, std::string key, const SourceLocation& location) {
    if (!machine_.times.before_first_move && clock_.time_s() <= 0) return true;
    const MoveInfo info = program_.make_info(MoveKind::dwell, location, 0);
    motion_.recorder().expect(info);
    words_s_ += seconds;
    return acceptance_.finish(enqueue({info.target_id, seconds, std::move(key)}), location);
}

}  // namespace gsim::simulation
