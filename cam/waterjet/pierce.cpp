#include "cam/waterjet/pierce.h"

#include <algorithm>

namespace gsim::waterjet {

double pierce_s(const PierceRule& rule, double thickness_mm, double separation_speed_mm_min) {
    constexpr double kSecondsInMinute = 60;
    return std::max(rule.least_s, rule.factor * thickness_mm * kSecondsInMinute / separation_speed_mm_min);
}

}  // namespace gsim::waterjet
