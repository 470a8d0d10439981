#include "tests/conformance/canon_reader.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tests/conformance/canon_call.h"
#include "tests/conformance/canon_frame.h"

namespace gsim::conformance {

namespace {

using Numbers = std::span<const double>;

constexpr double kMmPerInch = 25.4;
/// Distance before its target at which the stand-alone interpreter lets a probe trip.
constexpr double kProbeBackoff_mm = 0.254;

/// Reader of calls one by one, with modal state and moves so far.
class Reader {
  public:
    /// Returns false if the call lacks numbers that it needs.
    bool add_call(const CanonCall& call, long line);
    std::vector<ExpectedMove> moves() && { return std::move(moves_); }

  private:
    struct Handler {
        std::size_t min;  ///< Numbers that the call must hold.
        void (Reader::*handle)(Numbers);
    };
    static const std::map<std::string_view, Handler>& handlers();

    void take_words(const CanonCall& call);
    void work_offset(Numbers n) { frame_.set_work_offset(n.subspan(1)); }
    void g92_offset(Numbers n) { frame_.set_g92_offset(n); }
    void tool_offset(Numbers n) { frame_.set_tool_offset(n); }
    void rotation(Numbers n) { frame_.set_rotation_deg(n[0]); }
    void feed_mode(Numbers n) { feed_per_turn_ = n[1] == 1; }
    void feed_rate(Numbers n);
    void spindle_speed(Numbers n) { rpm_ = n[1]; }
    void spindle_mode(Numbers n) { constant_surface_speed_ = n[1] != 0; }
    void start_sync(Numbers) { synchronous_ = true; }
    void stop_sync(Numbers) { synchronous_ = false; }
    void traverse(Numbers n) { line(Kind::rapid, n); }
    void feed(Numbers n) { line(synchronous_ ? Kind::thread : Kind::linear, n); }
    void probe(Numbers n);
    void rigid_tap(Numbers n);
    void arc(Numbers n);
    void spline(Numbers) { add({.kind = Kind::spline}, {.at = at_}); }
    void dwell(Numbers n);

    void line(Kind kind, Numbers values);
    ExpectedMove& add(const Move& move, const PrintedPoint& end);
    void set_feed(ExpectedMove& expected) const;

    CanonFrame frame_;
    std::vector<ExpectedMove> moves_;
    AxisValues at_{};  // end of the reference's last move, machine coordinates
    Plane plane_ = Plane::xy;
    double feed_ = 0;
    double feed_unit_mm_ = 1;
    double rpm_ = 0;
    bool feed_per_turn_ = false;
    bool constant_surface_speed_ = false;
    bool synchronous_ = false;
    long line_ = 0;
};

const std::map<std::string_view, Reader::Handler>& Reader::handlers() {
    static const std::map<std::string_view, Handler> all{
        {"SET_G5X_OFFSET", {7, &Reader::work_offset}},
        {"SET_G92_OFFSET", {6, &Reader::g92_offset}},
        {"USE_TOOL_LENGTH_OFFSET", {6, &Reader::tool_offset}},
        {"SET_XY_ROTATION", {1, &Reader::rotation}},
        {"SET_FEED_MODE", {2, &Reader::feed_mode}},
        {"SET_FEED_RATE", {1, &Reader::feed_rate}},
        {"SET_SPINDLE_SPEED", {2, &Reader::spindle_speed}},
        {"SET_SPINDLE_MODE", {2, &Reader::spindle_mode}},
        {"START_SPEED_FEED_SYNC", {1, &Reader::start_sync}},
        {"STOP_SPEED_FEED_SYNCH", {0, &Reader::stop_sync}},
        {"STRAIGHT_TRAVERSE", {6, &Reader::traverse}},
        {"STRAIGHT_FEED", {6, &Reader::feed}},
        {"STRAIGHT_PROBE", {6, &Reader::probe}},
        {"RIGID_TAP", {3, &Reader::rigid_tap}},
        {"ARC_FEED", {9, &Reader::arc}},
        {"NURBS_FEED", {0, &Reader::spline}},
        {"DWELL", {1, &Reader::dwell}},
    };
    return all;
}

bool Reader::add_call(const CanonCall& call, long line) {
    line_ = line;
    const auto found = handlers().find(call.name);
    if (found == handlers().end()) {
        take_words(call);
        return true;
    }
    const std::vector<double> numbers = call.numbers();
    if (numbers.size() < found->second.min) return false;
    (this->*found->second.handle)(numbers);
    return true;
}

// Handles calls with a word as their argument.
void Reader::take_words(const CanonCall& call) {
    if (call.name == "USE_LENGTH_UNITS") {
        frame_.set_unit(call.arguments == "CANON_UNITS_INCHES" ? kMmPerInch : 1);
    } else if (call.name == "SELECT_PLANE") {
        plane_ = call.arguments == "CANON_PLANE_XZ"   ? Plane::zx
                 : call.arguments == "CANON_PLANE_YZ" ? Plane::yz
                                                      : Plane::xy;
    }
}

void Reader::line(Kind kind, Numbers values) {
    AxisValues printed{};
    std::copy_n(values.begin(), kAxisCount, printed.begin());
    add({.kind = kind}, frame_.to_machine(printed));
}

void Reader::probe(Numbers n) {
    const AxisValues start = at_;
    line(Kind::probe, n);
    ExpectedMove& probe = moves_.back();
    double distance_mm = 0;
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        distance_mm = std::hypot(distance_mm, start[axis] - probe.move.to[axis]);
    }
    if (distance_mm <= kProbeBackoff_mm) return;
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        probe.stop[axis] += (start[axis] - probe.stop[axis]) * kProbeBackoff_mm / distance_mm;
    }
    at_ = probe.stop;
}

// A feed keeps the unit in which it was given when the unit of lengths changes.
void Reader::feed_rate(Numbers n) {
    feed_ = n[0];
    feed_unit_mm_ = frame_.unit_mm();
}

// Adds moves there and back, with the rotary axes unchanged.
void Reader::rigid_tap(Numbers n) {
    const AxisValues start = at_;
    PrintedPoint end = frame_.to_machine({n[0], n[1], n[2]});
    std::copy(start.begin() + kLinearAxes, start.end(), end.at.begin() + kLinearAxes);
    add({.kind = Kind::thread}, end);
    add({.kind = Kind::thread}, {.at = start, .tolerance = end.tolerance});
}

void Reader::arc(Numbers n) {
    const auto [first, second] = plane_axes(plane_);
    const std::size_t third = 3 - first - second;
    AxisValues end{};
    AxisValues center{};
    end[first] = n[0];
    end[second] = n[1];
    center[first] = n[2];
    center[second] = n[3];
    end[third] = n[5];
    std::copy_n(n.begin() + 6, kAxisCount - kLinearAxes, end.begin() + kLinearAxes);
    const int turns = static_cast<int>(n[4]);
    Move move{.kind = turns < 0 ? Kind::arc_cw : Kind::arc_ccw};
    const AxisValues center_mm = frame_.to_machine(center).at;
    move.arc = ArcPart{
        frame_.turned(plane_normal(plane_)), {center_mm[0], center_mm[1], center_mm[2]}, std::abs(turns)};
    add(move, frame_.to_machine(end));
}

void Reader::dwell(Numbers n) {
    add({.kind = Kind::dwell, .dwell_s = n[0]}, {.at = at_});
}

ExpectedMove& Reader::add(const Move& move, const PrintedPoint& end) {
    ExpectedMove& expected = moves_.emplace_back();
    expected.move = move;
    expected.move.line = line_;
    expected.move.to = expected.stop = at_ = end.at;
    expected.tolerance = end.tolerance;
    set_feed(expected);
    return expected;
}

// A feed per turn is known only if the speed is; in a thread the pitch is programmed, not F.
void Reader::set_feed(ExpectedMove& expected) const {
    const Kind kind = expected.move.kind;
    if (kind == Kind::rapid || kind == Kind::dwell || kind == Kind::thread) return;
    if (feed_per_turn_ && (constant_surface_speed_ || rpm_ == 0)) return;
    const double per_min = feed_per_turn_ ? rpm_ : 1;
    expected.move.feed_per_min = feed_ * per_min;
    expected.feed_tolerance = kPrinted * per_min;
    expected.feed_unit_mm = feed_unit_mm_;
}

}  // namespace

Result<std::vector<ExpectedMove>> read_canon(std::istream& text) {
    Reader reader;
    std::string line;
    for (long number = 1; std::getline(text, line); ++number) {
        const auto call = read_canon_call(line);
        if (!call || reader.add_call(*call, number)) continue;
        return Unexpected(fmt::format("line {} of the canonical output lacks numbers: {}", number, line));
    }
    return std::move(reader).moves();
}

}  // namespace gsim::conformance
