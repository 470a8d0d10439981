#include "runtime/simulator/required_offset_shifts.h"

#include <algorithm>
#include <cmath>

namespace gsim::simulation {

namespace {

constexpr double kStepsPerMm = 1000;
constexpr double kRounding = 1e-6;  // of a step

double round_up(double value_mm) {
    return std::ceil(value_mm * kStepsPerMm - kRounding) / kStepsPerMm;
}

}  // namespace

void RequiredOffsetShifts::add(const Violation& violation) {
    if (violation.rotary || violation.offset.empty() || violation.forbidden_zone) {
        is_unfixable_ = true;
        return;
    }
    RequiredShift& shift = required_shifts_[{violation.offset, violation.axis}];
    double& travel = violation.value < violation.limit ? shift.up_mm : shift.down_mm;
    travel = std::max(travel, violation.amount());
}

std::vector<OffsetShift> RequiredOffsetShifts::shifts() const {
    std::vector<OffsetShift> shifts;
    for (const auto& [of, shift] : required_shifts_) {
        if (is_unfixable_ || (shift.up_mm > 0 && shift.down_mm > 0)) return {};
        const double shift_mm = shift.up_mm > 0 ? round_up(shift.up_mm) : -round_up(shift.down_mm);
        shifts.push_back({.offset = of.first, .axis = of.second, .shift_mm = shift_mm});
    }
    return shifts;
}

}  // namespace gsim::simulation
