#include "motion/planner/overtravel_log.h"

#include <algorithm>

namespace gsim::motion {

void OvertravelLog::note(const Overtravel& overtravel) {
    const auto found = std::find_if(overtravels_.begin(), overtravels_.end(), [&](const Overtravel& known) {
        return known.joint == overtravel.joint && known.limit == overtravel.limit;
    });
    if (found == overtravels_.end()) {
        overtravels_.push_back(overtravel);
    } else if (overtravel.excess() > found->excess()) {
        *found = overtravel;
    }
}

}  // namespace gsim::motion
