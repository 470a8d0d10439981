// Output of blocks with ramps in steps of time in LookAhead.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "motion/lookahead/look_ahead.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

namespace {

constexpr double kSecondsPerMinute = 60;

float per_minute(double value, int power) {
    for (int i = 0; i < power; ++i) value *= kSecondsPerMinute;
    return static_cast<float>(value);
}

SteppedBlock make_stepped_block(const Block& block, double entry_speed, double exit_speed) {
    return {static_cast<float>(block.distance()),
            per_minute(entry_speed, 1),
            per_minute(exit_speed, 1),
            per_minute(block.max_speed, 1),
            per_minute(block.acceleration, 2),
            per_minute(block.steps->acceleration, 2),
            per_minute(block.steps->jerk, 3)};
}

/// Parts of one law, in order. Parts that only continue at the speed of the last one are merged into it.
class SectionMerger {
  public:
    bool has_space_for(const LawSection& section) const {
        return count_ < TimeLaw::kMaxSections || (count_ > 0 && continues(section));
    }
    void add(LawSection section) {
        const double distance =
            section.v0 * section.duration_s + section.a0 * section.duration_s * section.duration_s / 2;
        if (count_ > 0 && continues(section)) {
            sections_[count_ - 1].duration_s += section.duration_s;
        } else {
            section.s0 = length_;
            sections_[count_++] = section;
        }
        length_ += distance;
    }
    bool empty() const { return count_ == 0; }
    double length() const { return length_; }
    TimeLaw law() const { return TimeLaw::from_sections({sections_.data(), count_}); }

  private:
    bool continues(const LawSection& section) const {
        constexpr double kSpeedRounding = 1e-6;  // relative: 32 bits are no nearer
        const LawSection& last = sections_[count_ - 1];
        const auto has_constant_speed = [](const LawSection& one) {
            return std::abs(one.a0) * one.duration_s <= kSpeedRounding * one.v0;
        };
        return has_constant_speed(last) && has_constant_speed(section) &&
               std::abs(section.v0 - last.v0) <= kSpeedRounding * last.v0;
    }

    std::array<LawSection, TimeLaw::kMaxSections> sections_{};
    std::size_t count_ = 0;
    double length_ = 0;
};

}  // namespace

void LookAhead::emit_steps(const Block& block, double exit_speed, bool reaches_target) {
    if (!(block.distance() > 0)) return;
    SectionMerger pending;
    bool pending_creeps = false;
    double from = 0;
    const auto emit = [&](bool reaches) {
        if (pending.empty()) return;
        const TimeLaw law = pending.law();
        const LimitCause by = pending_creeps ? LimitCause{LimitKind::short_brakes, -1}
                                             : limited_by(block, law, law.end_speed());
        emit_sections(block, law, from, by, reaches);
        from += pending.length();
        pending = {};
    };
    stepped_ramps_.drive(make_stepped_block(block, speed_, exit_speed), [&](const SteppedSection& section) {
        if (section.stops_short != pending_creeps || !pending.has_space_for(section.law)) emit(false);
        pending_creeps = section.stops_short;
        pending.add(section.law);
    });
    emit(reaches_target);
}

/// Outputs a part of the block that begins `from` past its start.
void LookAhead::emit_sections(const Block& block, const TimeLaw& law, double from, LimitCause limited_by,
                              bool reaches_target) {
    constexpr double kEndTolerance = 1e-6;  // relative: lengths are of 32 bits
    const double length = block.master.length;
    const double start = block.entry_blend.cut + from;
    const double end = start + law.length();
    const bool is_last = length - block.exit_cut - end <= kEndTolerance * length;
    Segment& segment = output_.begin(block.move.target_id);
    set_path(
        move_part(block.move, length, start, is_last ? length - block.exit_cut : end, setup_.position_joints),
        segment);
    segment.master = law;
    segment.master_limits = {std::max(block.max_speed, law.peak_speed()), block.steps->acceleration,
                             block.steps->acceleration, kUnlimited};
    segment.duration_s = law.duration_s();
    segment.limited_by = limited_by;
    segment.reaches_target = reaches_target;
    output_.finish();
}

}  // namespace gsim::motion
