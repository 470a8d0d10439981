#include "cam/waterjet/kerf.h"

#include <algorithm>

namespace gsim::waterjet {

double kerf_mm(const KerfRule& rule, double mixing_tube_mm) {
    return rule.width_to_tube * mixing_tube_mm;
}

double exit_kerf_mm(const KerfRule& rule, double kerf_mm, double separation_share) {
    return std::max(0.0, kerf_mm - 2 * rule.taper_mm * separation_share);
}

}  // namespace gsim::waterjet
