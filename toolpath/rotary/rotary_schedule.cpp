#include "toolpath/rotary/rotary_schedule.h"

#include <algorithm>

namespace gsim::path {

AxisValues RotarySchedule::at(std::size_t target) const {
    AxisValues found(static_cast<Eigen::Index>(count_));
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>((target - unknown) * count_), count_,
                found.begin());
    return found;
}

const AxisValues* RotarySchedule::find(const std::vector<Unwinding>& list, std::size_t target) {
    const auto found = std::lower_bound(
        list.begin(), list.end(), target,
        [](const Unwinding& each, std::size_t requested) { return each.target < requested; });
    return found != list.end() && found->target == target ? &found->to : nullptr;
}

const AxisValues* RotarySchedule::unwinding(std::size_t target) const {
    return find(unwindings, target);
}

const AxisValues* RotarySchedule::between_repeats(std::size_t target) const {
    return find(between, target);
}

}  // namespace gsim::path
