#include "runtime/monitors/zone_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/path/joint_motion.h"

namespace gsim::simulation {

using motion::Range;
using motion::Segment;

namespace {

constexpr double kContactTolerance_mm = 1e-6;

bool is_within(const Range& walls, double value) {
    return value >= walls.min - kContactTolerance_mm && value <= walls.max + kContactTolerance_mm;
}

bool is_within(const Range& walls, const Range& travel) {
    return travel.min >= walls.min && travel.max <= walls.max;
}

bool is_disjoint(const Range& walls, const Range& travel) {
    return travel.max < walls.min - kContactTolerance_mm || travel.min > walls.max + kContactTolerance_mm;
}

/// Instant at which something may begin.
struct Instant {
    double t_s;
    const BoxSide* passed;  ///< Side with the wall that the joint passes; null at a reversal or an end.
};

/// Adds all instants of one side: in between its joint moves in one direction and passes no wall.
void add_crossing_instants(const Segment& segment, const BoxSide& side, std::vector<Instant>& instants) {
    std::vector<double> ends{0, segment.duration_s};
    motion::add_reversal_times(segment, side.joint, ends);
    std::sort(ends.begin(), ends.end());
    double from_s = 0;
    double from = segment.start[side.joint];
    for (const double to_s : ends) {
        const double to = segment.position_at(to_s)[side.joint];
        instants.push_back({to_s, nullptr});
        for (const bool upper : {false, true}) {
            const double wall = upper ? side.walls.max : side.walls.min;
            if ((from < wall) == (to < wall) || from == wall || to == wall) continue;
            instants.push_back({motion::crossing_time_s(segment, side.joint, wall, from_s, to_s), &side});
        }
        from_s = to_s;
        from = to;
    }
}

std::vector<Instant> crossing_instants(const Segment& segment, std::span<const BoxSide> sides) {
    std::vector<Instant> instants;
    for (const BoxSide& side : sides) add_crossing_instants(segment, side, instants);
    std::stable_sort(instants.begin(), instants.end(),
                     [](const Instant& a, const Instant& b) { return a.t_s < b.t_s; });
    return instants;
}

bool is_above(const Range& walls, double value) {
    return value > (walls.min + walls.max) / 2;
}

/// Returns when the walls of a side were passed last, among the instants up to the last one, at which its
/// joint is beyond them. Otherwise returns since when it is not known to be within.
BoxViolation last_crossing(std::span<const Instant> preceding, const BoxSide& side, bool upper) {
    for (std::size_t i = preceding.size(); i-- > 0;) {
        if (preceding[i].passed == &side) return {preceding[i].t_s, side.axis, upper, false};
    }
    return {preceding.size() > 1 ? preceding[preceding.size() - 2].t_s : 0, side.axis, upper, false};
}

/// Expects that the box is left for good between the last two instants.
BoxViolation leaving(std::span<const BoxSide> sides, std::span<const Instant> preceding,
                     const rrs::JointPos& outside) {
    BoxViolation first{.t_s = std::numeric_limits<double>::infinity()};
    for (const BoxSide& side : sides) {
        const double value = outside[side.joint];
        if (is_within(side.walls, value)) continue;
        const BoxViolation left = last_crossing(preceding, side, is_above(side.walls, value));
        if (left.t_s < first.t_s) first = left;
    }
    return first;
}

/// Expects that the box is entered at an instant, and that `before` is outside.
BoxViolation entering(std::span<const BoxSide> sides, const Instant& instant, const rrs::JointPos& before) {
    BoxViolation entered{.t_s = instant.t_s};
    for (const BoxSide& side : sides) {
        const double value = before[side.joint];
        if (is_within(side.walls, value)) continue;
        entered.axis = side.axis;
        entered.upper = is_above(side.walls, value);
        if (instant.passed == &side) break;
    }
    return entered;
}

}  // namespace

bool ZoneBox::contains(const rrs::JointPos& joints) const {
    const auto within = [&](const BoxSide& side) { return is_within(side.walls, joints[side.joint]); };
    return std::all_of(sides().begin(), sides().end(), within);
}

bool ZoneBox::is_certainly_allowed(const Segment& segment) const {
    for (const BoxSide& side : sides()) {
        const Range travel = motion::range_bounds(segment, side.joint);
        if (stay_inside_ && !is_within(side.walls, travel)) return false;
        if (!stay_inside_ && is_disjoint(side.walls, travel)) return true;
    }
    return stay_inside_;
}

/// Expects a point that is not allowed.
BoxViolation ZoneBox::nearest_wall(const rrs::JointPos& joints) const {
    BoxViolation nearest{.at_start = true};
    double min = std::numeric_limits<double>::infinity();
    for (const BoxSide& side : sides()) {
        const double value = joints[side.joint];
        if (stay_inside_ && is_within(side.walls, value)) continue;
        const double below = std::abs(value - side.walls.min);
        const double above = std::abs(value - side.walls.max);
        if (std::min(below, above) >= min) continue;
        min = std::min(below, above);
        nearest.axis = side.axis;
        nearest.upper = above < below;
    }
    return nearest;
}

std::optional<BoxViolation> ZoneBox::first_violation(const Segment& segment) const {
    const std::vector<BoxViolationPeriod> found = violation_periods(segment, std::nullopt);
    return found.empty() ? std::nullopt : std::optional(found.front().entry);
}

/// Returns how far the joint across the wall of an offence is past it.
double ZoneBox::excess_mm(const BoxViolation& violation, const rrs::JointPos& joints) const {
    const auto side = std::find_if(sides().begin(), sides().end(),
                                   [&](const BoxSide& each) { return each.axis == violation.axis; });
    if (side == sides().end()) return 0;
    const double above = joints[side->joint] - (violation.upper ? side->walls.max : side->walls.min);
    return std::max(0.0, violation.upper == stay_inside_ ? above : -above);
}

std::vector<BoxViolationPeriod> ZoneBox::violation_periods(
    const Segment& segment, const std::optional<BoxViolationPeriod>& open) const {
    const bool always_allowed = is_certainly_allowed(segment);
    if (always_allowed && !open) return {};
    std::vector<BoxViolationPeriod> found;
    if (open) found.push_back(*open);
    const auto continues = [&] { return !found.empty() && !found.back().has_ended; };
    const auto check_instant = [&](const rrs::JointPos& at, const auto& violation) {
        if (!forbids(at)) {
            if (continues()) found.back().has_ended = true;
            return;
        }
        if (!continues()) found.push_back({.entry = violation()});
        found.back().excess_mm = std::max(found.back().excess_mm, excess_mm(found.back().entry, at));
    };
    check_instant(segment.start, [&] { return nearest_wall(segment.start); });
    if (always_allowed) return found;
    const std::vector<Instant> instants = crossing_instants(segment, sides());
    rrs::JointPos before = segment.start;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        const rrs::JointPos at = segment.position_at(instants[i].t_s);
        check_instant(at, [&] {
            return stay_inside_ ? leaving(sides(), {instants.data(), i + 1}, at)
                                : entering(sides(), instants[i], before);
        });
        before = at;
    }
    return found;
}

}  // namespace gsim::simulation
