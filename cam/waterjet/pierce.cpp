#include "cam/waterjet/pierce.h"

#include <algorithm>

#include "base/units.h"

namespace gsim::waterjet {

double pierce_s(const PierceRule& rule, double thickness_mm, double separation_speed_mm_min) {
    return std::max(rule.min_s, rule.factor * thickness_mm * kSecondsPerMinute / separation_speed_mm_min);
}

}  // namespace gsim::waterjet
