#include "runtime/processes/conveyor.h"

#include <algorithm>
#include <limits>

namespace gsim::process {

void Conveyor::set_speed(double speed_mm_s, double time_s) {
    position_mm_ = position_mm(time_s);
    last_change_s_ = time_s;
    speed_mm_s_ = speed_mm_s;
}

double Conveyor::arrival_time_s(double position_mm, double time_s) const {
    const double distance_mm = position_mm - this->position_mm(time_s);
    if (distance_mm == 0) return time_s;
    if (speed_mm_s_ == 0) return std::numeric_limits<double>::infinity();
    return std::max(time_s, time_s + distance_mm / speed_mm_s_);
}

}  // namespace gsim::process
