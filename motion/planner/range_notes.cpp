#include "motion/planner/range_notes.h"

#include <algorithm>

namespace gsim::motion {

void RangeNotes::note(const Excursion& excursion) {
    const auto found = std::find_if(excursions_.begin(), excursions_.end(), [&](const Excursion& known) {
        return known.joint == excursion.joint && known.limit == excursion.limit;
    });
    if (found == excursions_.end()) {
        excursions_.push_back(excursion);
    } else if (excursion.beyond() > found->beyond()) {
        *found = excursion;
    }
}

}  // namespace gsim::motion
