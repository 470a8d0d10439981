#include "runtime/monitors/zone_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/path/joint_way.h"

namespace gsim::simulation {

using motion::Range;
using motion::Segment;

namespace {

constexpr double kTouch_mm = 1e-6;

bool is_within(const Range& walls, double value) {
    return value >= walls.min - kTouch_mm && value <= walls.max + kTouch_mm;
}

bool is_within(const Range& walls, const Range& way) {
    return way.min >= walls.min && way.max <= walls.max;
}

bool is_apart(const Range& walls, const Range& way) {
    return way.max < walls.min - kTouch_mm || way.min > walls.max + kTouch_mm;
}

/// Instant at which something may begin.
struct Instant {
    double t_s;
    const BoxSide* passed;  ///< Side with the wall that the joint passes; null at a reversal or an end.
};

/// Adds all instants of one side: in between its joint moves in one direction and passes no wall.
void add_instants(const Segment& segment, const BoxSide& side, std::vector<Instant>& instants) {
    std::vector<double> ends{0, segment.duration_s};
    motion::add_turns(segment, side.joint, ends);
    std::sort(ends.begin(), ends.end());
    double from_s = 0;
    double from = segment.start[side.joint];
    for (const double to_s : ends) {
        const double to = segment.position_at(to_s)[side.joint];
        instants.push_back({to_s, nullptr});
        for (const bool upper : {false, true}) {
            const double wall = upper ? side.walls.max : side.walls.min;
            if ((from < wall) == (to < wall) || from == wall || to == wall) continue;
            instants.push_back({motion::passing_s(segment, side.joint, wall, from_s, to_s), &side});
        }
        from_s = to_s;
        from = to;
    }
}

std::vector<Instant> instants_of(const Segment& segment, std::span<const BoxSide> sides) {
    std::vector<Instant> instants;
    for (const BoxSide& side : sides) add_instants(segment, side, instants);
    std::stable_sort(instants.begin(), instants.end(),
                     [](const Instant& a, const Instant& b) { return a.t_s < b.t_s; });
    return instants;
}

bool is_above(const Range& walls, double value) {
    return value > (walls.min + walls.max) / 2;
}

/// Returns when the walls of a side were passed last, among the instants up to the last one, at which its
/// joint is beyond them. Otherwise returns since when it is not known to be within.
BoxOffence left_by(std::span<const Instant> until, const BoxSide& side, bool upper) {
    for (std::size_t i = until.size(); i-- > 0;) {
        if (until[i].passed == &side) return {until[i].t_s, side.axis, upper, false};
    }
    return {until.size() > 1 ? until[until.size() - 2].t_s : 0, side.axis, upper, false};
}

/// Expects that the box is left for good between the last two instants.
BoxOffence leaving(std::span<const BoxSide> sides, std::span<const Instant> until,
                   const rrs::JointPos& outside) {
    BoxOffence first{.t_s = std::numeric_limits<double>::infinity()};
    for (const BoxSide& side : sides) {
        const double value = outside[side.joint];
        if (is_within(side.walls, value)) continue;
        const BoxOffence left = left_by(until, side, is_above(side.walls, value));
        if (left.t_s < first.t_s) first = left;
    }
    return first;
}

/// Expects that the box is entered at an instant, and that `before` is outside.
BoxOffence entering(std::span<const BoxSide> sides, const Instant& instant, const rrs::JointPos& before) {
    BoxOffence entered{.t_s = instant.t_s};
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

bool ZoneBox::surely_allowed(const Segment& segment) const {
    for (const BoxSide& side : sides()) {
        const Range way = motion::wide_range(segment, side.joint);
        if (stay_inside_ && !is_within(side.walls, way)) return false;
        if (!stay_inside_ && is_apart(side.walls, way)) return true;
    }
    return stay_inside_;
}

/// Expects a point that is not allowed.
BoxOffence ZoneBox::nearest_wall(const rrs::JointPos& joints) const {
    BoxOffence nearest{.at_start = true};
    double least = std::numeric_limits<double>::infinity();
    for (const BoxSide& side : sides()) {
        const double value = joints[side.joint];
        if (stay_inside_ && is_within(side.walls, value)) continue;
        const double below = std::abs(value - side.walls.min);
        const double above = std::abs(value - side.walls.max);
        if (std::min(below, above) >= least) continue;
        least = std::min(below, above);
        nearest.axis = side.axis;
        nearest.upper = above < below;
    }
    return nearest;
}

std::optional<BoxOffence> ZoneBox::first_offence(const Segment& segment) const {
    const std::vector<BoxStay> found = stays(segment, std::nullopt);
    return found.empty() ? std::nullopt : std::optional(found.front().began);
}

/// Returns how far the joint across the wall of an offence is past it.
double ZoneBox::beyond_mm(const BoxOffence& offence, const rrs::JointPos& joints) const {
    const auto side = std::find_if(sides().begin(), sides().end(),
                                   [&](const BoxSide& each) { return each.axis == offence.axis; });
    if (side == sides().end()) return 0;
    const double above = joints[side->joint] - (offence.upper ? side->walls.max : side->walls.min);
    return std::max(0.0, offence.upper == stay_inside_ ? above : -above);
}

std::vector<BoxStay> ZoneBox::stays(const Segment& segment, const std::optional<BoxStay>& open) const {
    const bool surely = surely_allowed(segment);
    if (surely && !open) return {};
    std::vector<BoxStay> found;
    if (open) found.push_back(*open);
    const auto goes_on = [&] { return !found.empty() && !found.back().has_ended; };
    const auto look_at = [&](const rrs::JointPos& at, const auto& offence) {
        if (!forbids(at)) {
            if (goes_on()) found.back().has_ended = true;
            return;
        }
        if (!goes_on()) found.push_back({.began = offence()});
        found.back().beyond_mm = std::max(found.back().beyond_mm, beyond_mm(found.back().began, at));
    };
    look_at(segment.start, [&] { return nearest_wall(segment.start); });
    if (surely) return found;
    const std::vector<Instant> instants = instants_of(segment, sides());
    rrs::JointPos before = segment.start;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        const rrs::JointPos at = segment.position_at(instants[i].t_s);
        look_at(at, [&] {
            return stay_inside_ ? leaving(sides(), {instants.data(), i + 1}, at)
                                : entering(sides(), instants[i], before);
        });
        before = at;
    }
    return found;
}

}  // namespace gsim::simulation
