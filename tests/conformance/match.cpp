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
bool keeps_apart(const ExpectedMove& expected, const Move& found, const EvaluationState& state,
                 std::size_t axis) {
    return state.apart[axis] != 0 &&
           near(found.to[axis] - state.apart[axis], expected.move.to[axis], 2 * expected.tolerance[axis]);
}

Mismatch end_mismatch(const ExpectedMove& expected, const Move& found, const EvaluationState& state) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double expected_value = expected.move.to[axis];
        if (near(found.to[axis], expected_value, expected.tolerance[axis])) continue;
        if (keeps_apart(expected, found, state, axis)) continue;
        return fmt::format("end point: {} is {:.6f}, {:.6f} is expected", kAxes[axis], found.to[axis],
                           expected_value);
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
Mismatch plane_mismatch(const Move& expected_value, const Move& found) {
    const Vector& normal = expected_value.arc->normal;
    const bool same_kind = expected_value.kind == found.kind;
    if (same_direction(found.arc->normal, normal, same_kind ? 1 : -1)) return std::nullopt;
    if (same_direction(found.arc->normal, normal, same_kind ? -1 : 1)) {
        if (same_kind) return "sense: the arc goes the other way round";
        return fmt::format("kind: {}, {} is expected", name(found.kind), name(expected_value.kind));
    }
    return fmt::format("plane: its normal is {}, {} is expected",
                       text::joined(found.arc->normal, " ", "{:.6f}"), text::joined(normal, " ", "{:.6f}"));
}

// Along the arc's own axis a centre is irrelevant.
Mismatch center_mismatch(const ExpectedMove& expected, const ArcPart& found) {
    const ArcPart& expected_value = *expected.move.arc;
    Vector apart{};
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis)
        apart[axis] = found.center_mm[axis] - expected_value.center_mm[axis];
    const double along = dot(apart, expected_value.normal);
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        double tolerance = expected.tolerance[axis];
        for (std::size_t other = 0; other < kLinearAxes; ++other) {
            if (other == axis) continue;
            tolerance += std::abs(expected_value.normal[axis] * expected_value.normal[other]) *
                         expected.tolerance[other];
        }
        const double off = apart[axis] - along * expected_value.normal[axis];
        if (near(off, 0, tolerance)) continue;
        return fmt::format("arc centre: {} is {:.6f}, {:.6f} is expected", kAxes[axis],
                           expected_value.center_mm[axis] + off, expected_value.center_mm[axis]);
    }
    return std::nullopt;
}

Mismatch arc_mismatch(const ExpectedMove& expected, const Move& found) {
    if (Mismatch mismatch = plane_mismatch(expected.move, found)) return mismatch;
    const ArcPart& expected_value = *expected.move.arc;
    const ArcPart& arc = *found.arc;
    if (Mismatch mismatch = center_mismatch(expected, arc)) return mismatch;
    if (arc.turns != expected_value.turns) {
        return fmt::format("turns: {}, {} expected", arc.turns, expected_value.turns);
    }
    return std::nullopt;
}

bool only_rotary(const Move& found, const EvaluationState& state) {
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        if (!near(found.to[axis], state.found[axis], 0)) return false;
    }
    return !is_arc(found.kind);
}

double expected_feed(const ExpectedMove& expected, bool rotary_only) {
    return *expected.move.feed_per_min * (rotary_only ? 1 : expected.feed_unit_mm);
}

}  // namespace

bool feeds_agree(const ExpectedMove& expected, const Move& found, bool rotary_only) {
    if (!expected.move.feed_per_min) return true;
    if (!found.feed_per_min) return false;
    const double feed = expected_feed(expected, rotary_only);
    const double printed = expected.feed_tolerance * (rotary_only ? 1 : expected.feed_unit_mm);
    return std::abs(*found.feed_per_min - feed) <= printed + std::abs(feed) * kRelativeFeed;
}

Mismatch find_mismatch(const ExpectedMove& expected, const Move& found, const EvaluationState& state) {
    const Move& expected_value = expected.move;
    if (found.kind != expected_value.kind && !(is_arc(found.kind) && is_arc(expected_value.kind))) {
        return fmt::format("kind: {}, {} is expected", name(found.kind), name(expected_value.kind));
    }
    if (expected_value.kind == Kind::dwell) {
        if (std::abs(found.dwell_s - expected_value.dwell_s) <= kPrintedSeconds + kSeconds)
            return std::nullopt;
        return fmt::format("dwell: {:.6f} s, {:.4f} s are expected", found.dwell_s, expected_value.dwell_s);
    }
    if (Mismatch mismatch = end_mismatch(expected, found, state)) return mismatch;
    if (expected_value.arc) {
        if (Mismatch mismatch = arc_mismatch(expected, found)) return mismatch;
    }
    const bool rotary_only = only_rotary(found, state);
    if (feeds_agree(expected, found, rotary_only)) return std::nullopt;
    return fmt::format("feed: {}, {:.6g} is expected",
                       found.feed_per_min ? fmt::format("{:.6g}", *found.feed_per_min) : "none",
                       expected_feed(expected, rotary_only));
}

EvaluationState after(const ExpectedMove& expected, const Move& found, const EvaluationState& state) {
    if (expected.move.kind == Kind::dwell) return state;
    EvaluationState next;
    next.expected = expected.stop;
    next.found = found.to;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (near(found.to[axis], expected.stop[axis], expected.tolerance[axis])) continue;
        const bool probed = expected.move.kind == Kind::probe;
        next.apart[axis] = probed ? found.to[axis] - expected.stop[axis] : state.apart[axis];
    }
    return next;
}

bool has_no_length(const ExpectedMove& expected, const EvaluationState& state) {
    const Move& move = expected.move;
    if (move.kind == Kind::dwell) return move.dwell_s == 0;
    if (move.kind == Kind::spline || is_arc(move.kind)) return false;
    AxisValues tolerance = expected.tolerance;
    for (double& value : tolerance) value *= 2;  // the position before it was printed, too
    return near(move.to, state.expected, tolerance) || near(move.to, state.found, tolerance);
}

bool has_no_length(const Move& found, const EvaluationState& state, const AxisValues& tolerance) {
    if (found.kind == Kind::dwell) return found.dwell_s <= kPrintedSeconds;
    if (is_arc(found.kind)) return false;
    return near(found.to, state.found, tolerance);
}

}  // namespace gsim::conformance
