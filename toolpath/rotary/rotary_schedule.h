#pragma once

#include <cstddef>
#include <vector>

#include "toolpath/rotary/machine_space.h"

namespace gsim::path {

/// Rotary axis values on one path.
class RotarySchedule {
  public:
    explicit RotarySchedule(std::size_t rotary_count = 0) : count_(rotary_count) {}

    /// Returns true if the axes are at values of this path after a target. Otherwise they are as before it:
    /// so far only fixed or reference points came, which name no rotary axis.
    bool is_known(std::size_t target) const { return target >= unknown; }
    /// Returns the rotary values on arrival at a target that it knows; for a sub-path, after it.
    AxisValues at(std::size_t target) const;
    /// Returns the values to which the axes turn after a target, if they have to before they move on.
    const AxisValues* unwinding(std::size_t target) const;

    /// Returns the values to which they turn between two runs of a repeated sub-path, if they have to.
    const AxisValues* between_repeats(std::size_t target) const;

    struct Unwinding {
        std::size_t target = 0;
        AxisValues to;
    };
    std::size_t unknown = 0;            ///< So many targets at the beginning leave the axes as they come.
    std::vector<double> values;         ///< Values of all further targets, in order.
    std::vector<Unwinding> unwindings;  ///< By target.
    std::vector<Unwinding> between;     ///< By target; of repeated sub-paths.

  private:
    static const AxisValues* find(const std::vector<Unwinding>& list, std::size_t target);

    std::size_t count_;
};

}  // namespace gsim::path
