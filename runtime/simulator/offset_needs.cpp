#include "runtime/simulator/offset_needs.h"

#include <algorithm>
#include <cmath>

namespace gsim::simulation {

namespace {

constexpr double kStepsPerMm = 1000;
constexpr double kRounding = 1e-6;  // of a step

double rounded_up(double value_mm) {
    return std::ceil(value_mm * kStepsPerMm - kRounding) / kStepsPerMm;
}

}  // namespace

void OffsetNeeds::add(const Violation& violation) {
    if (violation.rotary || violation.offset.empty() || violation.forbidden_zone) {
        in_vain_ = true;
        return;
    }
    Need& need = needs_[{violation.offset, violation.axis}];
    double& way = violation.value < violation.limit ? need.up_mm : need.down_mm;
    way = std::max(way, violation.amount());
}

std::vector<OffsetShift> OffsetNeeds::shifts() const {
    std::vector<OffsetShift> shifts;
    for (const auto& [of, need] : needs_) {
        if (in_vain_ || (need.up_mm > 0 && need.down_mm > 0)) return {};
        const double shift_mm = need.up_mm > 0 ? rounded_up(need.up_mm) : -rounded_up(need.down_mm);
        shifts.push_back({.offset = of.first, .axis = of.second, .shift_mm = shift_mm});
    }
    return shifts;
}

}  // namespace gsim::simulation
