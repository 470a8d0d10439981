// Output of blocks with ramps in steps of time in LookAhead.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "motion/lookahead/look_ahead.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

namespace {

constexpr double kMinute_s = 60;

float per_minute(double value, int power) {
    for (int i = 0; i < power; ++i) value *= kMinute_s;
    return static_cast<float>(value);
}

SteppedBlock stepped(const Block& block, double entry_speed, double exit_speed) {
    return {static_cast<float>(block.way()),   per_minute(entry_speed, 1),
            per_minute(exit_speed, 1),         per_minute(block.max_speed, 1),
            per_minute(block.acceleration, 2), per_minute(block.steps->acceleration, 2),
            per_minute(block.steps->jerk, 3)};
}

/// Parts of one law, one after the other. Parts that only continue at the speed of the last one are merged
/// into it.
class PieceLaw {
  public:
    bool takes(const LawPiece& piece) const {
        return count_ < TimeLaw::kMaxPieces || (count_ > 0 && goes_on(piece));
    }
    void add(LawPiece piece) {
        const double way = piece.v0 * piece.duration_s + piece.a0 * piece.duration_s * piece.duration_s / 2;
        if (count_ > 0 && goes_on(piece)) {
            pieces_[count_ - 1].duration_s += piece.duration_s;
        } else {
            piece.s0 = length_;
            pieces_[count_++] = piece;
        }
        length_ += way;
    }
    bool empty() const { return count_ == 0; }
    double length() const { return length_; }
    TimeLaw law() const { return TimeLaw::of_pieces({pieces_.data(), count_}); }

  private:
    bool goes_on(const LawPiece& piece) const {
        constexpr double kSameSpeed = 1e-6;  // relative: 32 bits are no nearer
        const LawPiece& last = pieces_[count_ - 1];
        const auto even = [](const LawPiece& one) {
            return std::abs(one.a0) * one.duration_s <= kSameSpeed * one.v0;
        };
        return even(last) && even(piece) && std::abs(piece.v0 - last.v0) <= kSameSpeed * last.v0;
    }

    std::array<LawPiece, TimeLaw::kMaxPieces> pieces_{};
    std::size_t count_ = 0;
    double length_ = 0;
};

}  // namespace

void LookAhead::put_out_steps(const Block& block, double exit_speed, bool reaches_target) {
    if (!(block.way() > 0)) return;
    PieceLaw held;
    bool held_crawls = false;
    double from = 0;
    const auto put_out = [&](bool reaches) {
        if (held.empty()) return;
        const TimeLaw law = held.law();
        const LimitedBy by =
            held_crawls ? LimitedBy{LimitKind::short_brakes, -1} : limited_by(block, law, law.end_speed());
        put_out_pieces(block, law, from, by, reaches);
        from += held.length();
        held = {};
    };
    stepped_.drive(stepped(block, speed_, exit_speed), [&](const SteppedPiece& piece) {
        if (piece.falls_short != held_crawls || !held.takes(piece.law)) put_out(false);
        held_crawls = piece.falls_short;
        held.add(piece.law);
    });
    put_out(reaches_target);
}

/// Outputs a part of the block that begins `from` after its start.
void LookAhead::put_out_pieces(const Block& block, const TimeLaw& law, double from, LimitedBy limited_by,
                               bool reaches_target) {
    constexpr double kSameEnd = 1e-6;  // relative: lengths are of 32 bits
    const double length = block.lead.length;
    const double start = block.entry_blend.cut + from;
    const double end = start + law.length();
    const bool is_last = length - block.exit_cut - end <= kSameEnd * length;
    Segment& segment = output_.begin(block.move.target_id);
    set_way(
        move_part(block.move, length, start, is_last ? length - block.exit_cut : end, setup_.position_joints),
        segment);
    segment.lead = law;
    segment.lead_limits = {std::max(block.max_speed, law.peak_speed()), block.steps->acceleration,
                           block.steps->acceleration, kUnlimited};
    segment.duration_s = law.duration_s();
    segment.limited_by = limited_by;
    segment.reaches_target = reaches_target;
    output_.finish();
}

}  // namespace gsim::motion
