#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "motion/segment/segment.h"

namespace gsim::simulation {

/// Two walls across one joint, in its values (mm).
struct BoxSide {
    std::size_t axis = 0;  ///< 0 x, 1 y, 2 z.
    int joint = 0;
    motion::Range walls;
};

/// First instant at which a segment does what a box forbids.
struct BoxViolation {
    double t_s = 0;         ///< Since the start of the segment.
    std::size_t axis = 0;   ///< Axis of the passed wall: 0 x, 1 y, 2 z.
    bool upper = false;     ///< True for the upper one.
    bool at_start = false;  ///< True already at the segment start; no wall is passed.
};

/// Stay of the joints at values that a box does not allow.
struct BoxViolationPeriod {
    BoxViolation entry;    ///< In the segment in which it began.
    double excess_mm = 0;  ///< Max distance past the wall of `entry` of the joint across it.
    bool has_ended = false;
};

/// Box in joint values that position joints must stay in or out of. The walls belong to it; a value nearer to
/// a wall than 1e-6 mm is on it.
class ZoneBox {
  public:
    explicit ZoneBox(bool stay_inside = false) : stay_inside_(stay_inside) {}

    /// Adds a side, at most one for each axis.
    void add_side(const BoxSide& side) { sides_[count_++] = side; }
    std::span<const BoxSide> sides() const { return {sides_.data(), count_}; }

    bool contains(const rrs::JointPos& joints) const;
    /// Returns the first instant of the segment that is not allowed: a root of its path and its time law, to
    /// rounding. Touching a box from outside counts as being in it; touching its walls from inside does not
    /// count as leaving it.
    std::optional<BoxViolation> first_violation(const motion::Segment& segment) const;
    /// Returns all stays of a segment that the box does not allow, in the order of time. `open` is the one
    /// that continues from the segment before, and is then the first of these; the last may continue past
    /// this one.
    std::vector<BoxViolationPeriod> violation_periods(const motion::Segment& segment,
                                                      const std::optional<BoxViolationPeriod>& open) const;

  private:
    bool is_certainly_allowed(const motion::Segment& segment) const;
    BoxViolation nearest_wall(const rrs::JointPos& joints) const;
    bool forbids(const rrs::JointPos& joints) const { return contains(joints) != stay_inside_; }
    double excess_mm(const BoxViolation& violation, const rrs::JointPos& joints) const;

    std::array<BoxSide, 3> sides_;
    std::size_t count_ = 0;
    bool stay_inside_;
};

}  // namespace gsim::simulation
