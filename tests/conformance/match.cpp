#include "tests/conformance/match.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/format.h"

namespace gsim::conformance {

namespace {

using Mismatch = std::optional<std::string>;

constexpr double kRounding = 1e-6;          // of sums of printed and computed values, mm and deg
constexpr double kRelativeFeed = 1e-6;      // feeds that follow from a length and a time
constexpr double kPrintedSeconds = 5e-5;    // of a dwell: four digits after the point
constexpr double kPrintedDirection = 2e-6;  // under a rotation of four digits after the point, in deg
constexpr double kSeconds = 1e-6;           // of sums of times

bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance + kRounding;
}

bool near(const AxisValues& a, const AxisValues& b, const AxisValues& tolerance) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (!near(a[axis], b[axis], tolerance[axis])) return false;
    }
    return true;
}

// Both sides keep the distance that a probe left between them; that distance was printed, too.
bool keeps_apart(const ExpectedMove& expected, const Move& found, const Standing& standing,
                 std::size_t axis) {
    return standing.apart[axis] != 0 &&
           near(found.to[axis] - standing.apart[axis], expected.move.to[axis], 2 * expected.tolerance[axis]);
}

Mismatch end_mismatch(const ExpectedMove& expected, const Move& found, const Standing& standing) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double wanted = expected.move.to[axis];
        if (near(found.to[axis], wanted, expected.tolerance[axis])) continue;
        if (keeps_apart(expected, found, standing, axis)) continue;
        return fmt::format("end point: {} is {:.6f}, {:.6f} is expected", kAxes[axis], found.to[axis],
                           wanted);
    }
    return std::nullopt;
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Returns true if both are that vector, or one is the opposite of the other.
bool same_direction(const Vector& a, const Vector& b, double sense) {
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        if (!near(a[axis], sense * b[axis], kPrintedDirection)) return false;
    }
    return true;
}

// A plane has two normals, and the sense of an arc refers to the given one.
Mismatch plane_mismatch(const Move& wanted, const Move& found) {
    const Vector& normal = wanted.arc->normal;
    const bool same_kind = wanted.kind == found.kind;
    if (same_direction(found.arc->normal, normal, same_kind ? 1 : -1)) return std::nullopt;
    if (same_direction(found.arc->normal, normal, same_kind ? -1 : 1)) {
        if (same_kind) return "sense: the arc goes the other way round";
        return fmt::format("kind: {}, {} is expected", name(found.kind), name(wanted.kind));
    }
    return fmt::format("plane: its normal is {}, {} is expected",
                       text::joined(found.arc->normal, " ", "{:.6f}"), text::joined(normal, " ", "{:.6f}"));
}

// Along the arc's own axis a centre is irrelevant.
Mismatch center_mismatch(const ExpectedMove& expected, const ArcPart& found) {
    const ArcPart& wanted = *expected.move.arc;
    Vector apart{};
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis)
        apart[axis] = found.center_mm[axis] - wanted.center_mm[axis];
    const double along = dot(apart, wanted.normal);
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        double tolerance = expected.tolerance[axis];
        for (std::size_t other = 0; other < kLinearAxes; ++other) {
            if (other == axis) continue;
            tolerance += std::abs(wanted.normal[axis] * wanted.normal[other]) * expected.tolerance[other];
        }
        const double off = apart[axis] - along * wanted.normal[axis];
        if (near(off, 0, tolerance)) continue;
        return fmt::format("arc centre: {} is {:.6f}, {:.6f} is expected", kAxes[axis],
                           wanted.center_mm[axis] + off, wanted.center_mm[axis]);
    }
    return std::nullopt;
}

Mismatch arc_mismatch(const ExpectedMove& expected, const Move& found) {
    if (Mismatch mismatch = plane_mismatch(expected.move, found)) return mismatch;
    const ArcPart& wanted = *expected.move.arc;
    const ArcPart& arc = *found.arc;
    if (Mismatch mismatch = center_mismatch(expected, arc)) return mismatch;
    if (arc.turns != wanted.turns) {
        return fmt::format("turns: {}, {} expected", arc.turns, wanted.turns);
    }
    return std::nullopt;
}

bool only_rotary(const Move& found, const Standing& standing) {
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        if (!near(found.to[axis], standing.found[axis], 0)) return false;
    }
    return !is_arc(found.kind);
}

double feed_of(const ExpectedMove& expected, bool rotary_only) {
    return *expected.move.feed_per_min * (rotary_only ? 1 : expected.feed_unit_mm);
}

}  // namespace

bool feeds_agree(const ExpectedMove& expected, const Move& found, bool rotary_only) {
    if (!expected.move.feed_per_min) return true;
    if (!found.feed_per_min) return false;
    const double feed = feed_of(expected, rotary_only);
    const double printed = expected.feed_tolerance * (rotary_only ? 1 : expected.feed_unit_mm);
    return std::abs(*found.feed_per_min - feed) <= printed + std::abs(feed) * kRelativeFeed;
}

Mismatch find_mismatch(const ExpectedMove& expected, const Move& found, const Standing& standing) {
    const Move& wanted = expected.move;
    if (found.kind != wanted.kind && !(is_arc(found.kind) && is_arc(wanted.kind))) {
        return fmt::format("kind: {}, {} is expected", name(found.kind), name(wanted.kind));
    }
    if (wanted.kind == Kind::dwell) {
        if (std::abs(found.dwell_s - wanted.dwell_s) <= kPrintedSeconds + kSeconds) return std::nullopt;
        return fmt::format("dwell: {:.6f} s, {:.4f} s are expected", found.dwell_s, wanted.dwell_s);
    }
    if (Mismatch mismatch = end_mismatch(expected, found, standing)) return mismatch;
    if (wanted.arc) {
        if (Mismatch mismatch = arc_mismatch(expected, found)) return mismatch;
    }
    const bool rotary_only = only_rotary(found, standing);
    if (feeds_agree(expected, found, rotary_only)) return std::nullopt;
    return fmt::format("feed: {}, {:.6g} is expected",
                       found.feed_per_min ? fmt::format("{:.6g}", *found.feed_per_min) : "none",
                       feed_of(expected, rotary_only));
}

Standing after(const ExpectedMove& expected, const Move& found, const Standing& standing) {
    if (expected.move.kind == Kind::dwell) return standing;
    Standing next;
    next.expected = expected.stop;
    next.found = found.to;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (near(found.to[axis], expected.stop[axis], expected.tolerance[axis])) continue;
        const bool probed = expected.move.kind == Kind::probe;
        next.apart[axis] = probed ? found.to[axis] - expected.stop[axis] : standing.apart[axis];
    }
    return next;
}

bool has_no_length(const ExpectedMove& expected, const Standing& standing) {
    const Move& move = expected.move;
    if (move.kind == Kind::dwell) return move.dwell_s == 0;
    if (move.kind == Kind::spline || is_arc(move.kind)) return false;
    AxisValues tolerance = expected.tolerance;
    for (double& value : tolerance) value *= 2;  // the position before it was printed, too
    return near(move.to, standing.expected, tolerance) || near(move.to, standing.found, tolerance);
}

bool has_no_length(const Move& found, const Standing& standing, const AxisValues& tolerance) {
    if (found.kind == Kind::dwell) return found.dwell_s <= kPrintedSeconds;
    if (is_arc(found.kind)) return false;
    return near(found.to, standing.found, tolerance);
}

}  // namespace gsim::conformance
