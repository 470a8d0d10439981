#include "tests/conformance/compare.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "tests/conformance/match.h"

namespace gsim::conformance {

namespace {

std::string with_line(const char* where, const Move& move) {
    return fmt::format("{} {}: {}", where, move.line, describe(move));
}

std::size_t leading_splines(std::span<const ExpectedMove> expected) {
    const auto end = std::find_if(expected.begin(), expected.end(),
                                  [](const ExpectedMove& e) { return e.move.kind != Kind::spline; });
    return static_cast<std::size_t>(end - expected.begin());
}

// A curve is driven as arcs, and as lines if it is straight.
bool may_be_of_curve(const Move& move) {
    return move.kind == Kind::spline || is_arc(move.kind);
}

// Returns true if each move has the feed of one of the splines.
bool spline_feeds_agree(std::span<const ExpectedMove> splines, std::span<const Move> moves) {
    return std::all_of(moves.begin(), moves.end(), [splines](const Move& move) {
        return std::any_of(splines.begin(), splines.end(),
                           [&move](const ExpectedMove& spline) { return feeds_agree(spline, move, false); });
    });
}

class Comparison {
  public:
    Comparison(std::span<const ExpectedMove> expected, std::span<const Move> found)
        : expected_(expected), found_(found) {}

    Verdict run() {
        while (!verdict_.difference && (!expected_.empty() || !found_.empty())) step();
        return std::move(verdict_);
    }

  private:
    void step();
    bool take_splines();
    bool leave_out();
    void agree();
    void differ(std::string what);

    std::span<const ExpectedMove> expected_;  // what is not compared yet, of both
    std::span<const Move> found_;
    EvaluationState standing_;
    AxisValues tolerance_{};  // of the last move of the reference
    Verdict verdict_;
};

void Comparison::step() {
    if (!expected_.empty() && !found_.empty()) {
        if (expected_[0].move.kind == Kind::spline && may_be_of_curve(found_[0])) {
            if (!take_splines()) differ("splines: the moves do not go with the splines of the reference");
            return;
        }
        std::optional<std::string> mismatch = find_mismatch(expected_[0], found_[0], standing_);
        if (!mismatch) return agree();
        if (!leave_out()) differ(*std::move(mismatch));
        return;
    }
    if (!leave_out()) {
        differ(found_.empty() ? "order: gsim has no further move"
                              : "order: the reference has no further move");
    }
}

// The reference prints no points of a spline. It represents the arcs and lines of one line, or a part of them
// if a loop puts splines of one line in a row.
bool Comparison::take_splines() {
    const std::size_t splines = leading_splines(expected_);
    std::size_t moves = 0;
    std::size_t lines = 0;
    for (; moves < found_.size() && may_be_of_curve(found_[moves]); ++moves) {
        if (moves > 0 && found_[moves].line == found_[moves - 1].line) continue;
        if (lines == splines) break;
        ++lines;
    }
    if (splines > moves) return false;
    if (!spline_feeds_agree(expected_.first(splines), found_.first(moves))) return false;
    standing_ = {.expected = found_[moves - 1].to, .found = found_[moves - 1].to};
    verdict_.agreed += splines;
    expected_ = expected_.subspan(splines);
    found_ = found_.subspan(moves);
    return true;
}

// Leaves out a move without length; returns false if neither side has one.
bool Comparison::leave_out() {
    if (!expected_.empty() && has_no_length(expected_[0], standing_)) {
        standing_.expected = expected_[0].stop;
        expected_ = expected_.subspan(1);
        return true;
    }
    if (!found_.empty() && has_no_length(found_[0], standing_, tolerance_)) {
        standing_.found = found_[0].to;
        found_ = found_.subspan(1);
        return true;
    }
    return false;
}

void Comparison::agree() {
    standing_ = after(expected_[0], found_[0], standing_);
    if (expected_[0].move.kind != Kind::dwell) tolerance_ = expected_[0].tolerance;
    ++verdict_.agreed;
    expected_ = expected_.subspan(1);
    found_ = found_.subspan(1);
}

void Comparison::differ(std::string what) {
    Difference difference{.what = std::move(what), .expected = "none", .found = "none"};
    if (!expected_.empty()) difference.expected = with_line("canonical line", expected_[0].move);
    if (!found_.empty()) difference.found = with_line("program line", found_[0]);
    verdict_.difference = std::move(difference);
}

}  // namespace

Verdict compare(std::span<const ExpectedMove> expected, std::span<const Move> found) {
    return Comparison(expected, found).run();
}

}  // namespace gsim::conformance
