#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "toolpath/model/states.h"
#include "toolpath/rotary/machine_space.h"

namespace gsim::path {

/// Where the rotary axes stand on one path.
class PathTurns {
  public:
    explicit PathTurns(std::size_t rotary_count = 0) : count_(rotary_count) {}

    /// Whether the axes stand at values of this path behind a target; else they stand as they did before it:
    /// so far there were fixed or reference points alone, which name no rotary axis.
    bool knows(std::size_t target) const { return target >= unknown; }
    /// The rotary values on arrival at a target that it knows; of a sub-path, behind it.
    AxisValues at(std::size_t target) const;
    /// Where the axes turn once a target is done, if they have to before they go on.
    const AxisValues* unwinding(std::size_t target) const;

    /// Where they turn between two runs of a repeated sub-path, if they have to.
    const AxisValues* between_repeats(std::size_t target) const;

    struct Unwinding {
        std::size_t target = 0;
        AxisValues to;
    };
    std::size_t unknown = 0;            ///< So many targets at the beginning leave the axes as they come.
    std::vector<double> values;         ///< Of all targets behind these, one behind the other.
    std::vector<Unwinding> unwindings;  ///< By target.
    std::vector<Unwinding> between;     ///< By target; of repeated sub-paths.

  private:
    static const AxisValues* find(const std::vector<Unwinding>& list, std::size_t target);

    std::size_t count_;
};

struct RotaryOptions {
    bool as_given =
        false;  ///< rotary_deg is what the axes go to, not an orientation that whole turns may lead to.
};

/// Chooses, of all rotary values that give each point's orientation within the axes' ranges, those that turn
/// least over the whole of a path (dynamic programming over the points). While the tool cuts, axes go the
/// short way; where their ranges do not allow it, the tool stops and the axes unwind, as seldom as can be.
/// Each path is planned for itself, since all its users share it. One PathTurns for each path.
tl::expected<std::vector<PathTurns>, Fault> plan_rotary(const Program& program, const MachineSpace& space,
                                                        const States& states, const RotaryOptions& options);

/// Whether a point is reached while the tool cuts: its motion is at feed, and the waterjet is on or the
/// program has none.
bool is_cutting(const Point& point, const State& before, bool program_has_jet);

/// Whether any action of the program turns a waterjet on.
bool has_jet(const Program& program);

}  // namespace gsim::path
