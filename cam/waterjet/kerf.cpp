#include "cam/waterjet/kerf.h"

#include <algorithm>

namespace gsim::waterjet {

double kerf_mm(const KerfRule& rule, double mixing_tube_mm) {
    return rule.width_to_tube * mixing_tube_mm;
}

double taper_mm(const KerfRule& rule, double kerf_mm, double speed_ratio) {
    return std::min(kerf_mm / 2, rule.taper_mm * speed_ratio);
}

double exit_kerf_mm(const KerfRule& rule, double kerf_mm, double speed_ratio) {
    return kerf_mm - 2 * taper_mm(rule, kerf_mm, speed_ratio);
}

}  // namespace gsim::waterjet
