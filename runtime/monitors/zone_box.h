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

/// Where a segment first does what a box forbids.
struct BoxOffence {
    double t_s = 0;         ///< Since the start of the segment.
    std::size_t axis = 0;   ///< Whose wall is passed: 0 x, 1 y, 2 z.
    bool upper = false;     ///< Which of the two.
    bool at_start = false;  ///< It is so where the segment starts, and nothing is passed.
};

/// A stay of the joints where a box does not allow them.
struct BoxStay {
    BoxOffence began;      ///< In the segment in which it began.
    double beyond_mm = 0;  ///< How far past the wall of `began` the joint across it goes.
    bool has_ended = false;
};

/// A box in joint values that position joints must stay in or out of. The walls belong to it; what is nearer
/// to a wall than 1e-6 mm is on it.
class ZoneBox {
  public:
    explicit ZoneBox(bool stay_inside = false) : stay_inside_(stay_inside) {}

    /// At most once for each axis.
    void add_side(const BoxSide& side) { sides_[count_++] = side; }
    std::span<const BoxSide> sides() const { return {sides_.data(), count_}; }

    bool contains(const rrs::JointPos& joints) const;
    /// The first instant of the segment that is not allowed: a root of its path and its time law, to
    /// rounding. To touch a box from outside is to be in it, to touch its walls from inside is not to leave
    /// it.
    std::optional<BoxOffence> first_offence(const motion::Segment& segment) const;
    /// All stays of a segment where the box does not allow them, in the order of time. `open` is the one that
    /// goes on from the segment before, and is the first of these then; the last may go on behind this one.
    std::vector<BoxStay> stays(const motion::Segment& segment, const std::optional<BoxStay>& open) const;

  private:
    bool surely_allowed(const motion::Segment& segment) const;
    BoxOffence nearest_wall(const rrs::JointPos& joints) const;
    bool forbids(const rrs::JointPos& joints) const { return contains(joints) != stay_inside_; }
    double beyond_mm(const BoxOffence& offence, const rrs::JointPos& joints) const;

    std::array<BoxSide, 3> sides_;
    std::size_t count_ = 0;
    bool stay_inside_;
};

}  // namespace gsim::simulation
