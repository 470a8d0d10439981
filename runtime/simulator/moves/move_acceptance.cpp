#include "runtime/simulator/moves/move_acceptance.h"

#include <string>

namespace gsim::simulation {

bool MoveAcceptance::finish(const motion::EnqueueResult& enqueue, const SourceLocation& location) {
    settings_.end_exact_stop();
    for (const std::string& remark : motion_.source().drain_warnings()) warnings_.add(remark);
    if (!violations_.check()) return false;
    if (!enqueue) return outcome_.fail(enqueue.error(), location);
    violations_.ranges().add_last(location);
    if (*enqueue) {
        warnings_.add(
            "an inverse time feed (G93) requires less time than the machine's limits allow; the limits "
            "apply");
    }
    return !outcome_.is_past_max_time() || outcome_.stop_for_time(location);
}

}  // namespace gsim::simulation
