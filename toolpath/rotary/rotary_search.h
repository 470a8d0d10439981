#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "toolpath/rotary/machine_space.h"
#include "toolpath/rotary/rotary_schedule.h"

namespace gsim::path {

/// Search through one path for the rotary values with the smallest turns (dynamic programming): the
/// candidates of each target, and the predecessor of each.
class RotarySearch {
  public:
    explicit RotarySearch(std::size_t rotary_count) : rotary_count_(rotary_count) {}

    /// Returns the possible axis values; empty before the first target that sets them.
    const std::vector<AxisValues>& now() const { return joint_values_; }
    /// Counts a target at the beginning that leaves the axes as they are.
    void pass() { ++unknown_; }

    /// Begins with the candidates of the first target that sets the axes. `must_be_near_home`: the axes must
    /// reach it from anywhere by the short turn.
    void begin(std::vector<AxisValues> candidates, const AxisValues& home, bool must_be_near_home);
    /// Advances to the candidates of the next target; before, the axes may turn on the spot. Returns false if
    /// no candidate can be reached by the short turn that cutting demands.
    bool step(std::vector<AxisValues> candidates, bool cutting, double stop_cost);
    /// Ends a sub-path with one candidate, which leaves the axes at the first of these values; to the others
    /// they may turn on the spot.
    void leave(std::vector<AxisValues> values);
    /// Returns the cheapest values for all targets.
    RotarySchedule result() const;

  private:
    void add_layer(std::vector<AxisValues> candidates, const std::vector<std::uint8_t>& from);
    void relax_turns_in_place(double stop_cost);
    AxisValues value(std::size_t layer, std::size_t candidate) const;

    std::size_t rotary_count_;
    std::size_t unknown_ = 0;
    std::vector<AxisValues> joint_values_;
    std::vector<double> costs_;              ///< Of each of joint_values_.
    std::vector<std::size_t> layer_begins_;  ///< Start of each target's candidates.
    std::vector<double> values_;             ///< Of all candidates.
    std::vector<std::uint8_t> from_;         ///< Which candidate before leads here.
    std::vector<std::uint8_t>
        in_place_predecessor_;  ///< Which candidate of the same target turns to this one on the spot.
};

}  // namespace gsim::path
