#include "codegen/post/feed_words.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace gsim::codegen {

namespace {

constexpr int kSignificantDigits = 7;
constexpr double kUnitsPerMm = 1e6;

// F is written in each block, with the digits that short and long times need.
void write_inverse_time(ProgramText& block, double per_min) {
    const int integer_digits = static_cast<int>(std::ceil(std::log10(per_min)));
    block.code("F" + trimmed(per_min, std::clamp(kSignificantDigits - integer_digits, 3, 12)));
}

}  // namespace

FeedWords::FeedWords(const Post& post, const Options& options)
    : post_(post),
      options_(options),
      format_(post.numbers.decimals_feed, post.numbers.zeros),
      mode_(initial_mode()) {}

double FeedWords::in_unit(double mm) const {
    return options_.inch ? mm / kMmPerInch : mm;
}

std::int64_t FeedWords::positive_increments(double value) const {
    return std::max<std::int64_t>(1, format_.increments(value));
}

FeedWords::FeedMode FeedWords::mode_for(const GcodeFeed& feed) const {
    if (feed.duration_s && !post_.feed_modes.inverse_time.empty()) return FeedMode::inverse_time;
    if (feed.per_rev_mm && !post_.feed_modes.per_revolution.empty()) return FeedMode::per_revolution;
    return FeedMode::per_minute;
}

void FeedWords::write_mode(ProgramText& block, const GcodeFeed& feed) {
    const FeedMode mode = mode_for(feed);
    if (mode == mode_) return;
    mode_ = mode;
    forget_value();  // an F of one mode has no meaning in another
    const FeedModes& words = post_.feed_modes;
    switch (mode) {
        case FeedMode::inverse_time: return block.code(words.inverse_time);
        case FeedMode::per_revolution: return block.code(words.per_revolution);
        default: return block.code(words.per_minute);
    }
}

void FeedWords::write(ProgramText& block, const GcodeFeed& feed, double turn_rad) {
    const FeedMode mode = mode_for(feed);
    if (mode == FeedMode::inverse_time) {
        const bool by_angle = post_.feed_modes.inverse_time_by_angle && turn_rad > 0;
        return write_inverse_time(block, (by_angle ? turn_rad : 1) * kSecondsPerMinute / *feed.duration_s);
    }
    if (mode == FeedMode::per_revolution) {
        const double per_rev = in_unit(*feed.per_rev_mm);
        const std::int64_t next = std::llround(per_rev * kUnitsPerMm);
        if (next != printed_) block.code("F" + trimmed(per_rev, kValueDecimals));
        printed_ = next;
        return;
    }
    const std::int64_t next = positive_increments(feed.rotary ? feed.per_min : in_unit(feed.per_min));
    if (next == printed_ && !options_.verbose) return;
    printed_ = next;
    block.word('F', next, format_);
}

std::string FeedWords::text(double mm_min) const {
    fmt::memory_buffer number;
    format_.append(number, positive_increments(in_unit(mm_min)));
    return fmt::to_string(number);
}

void FeedWords::write_acceleration(ProgramText& text, double mm_s2) {
    if (post_.acceleration.set.empty()) return;
    const std::int64_t next = positive_increments(in_unit(mm_s2));
    if (next == acceleration_increments_ && !options_.verbose) return;
    acceleration_increments_ = next;
    fmt::memory_buffer number;
    format_.append(number, next);
    text.placeholders()["acceleration"] = fmt::to_string(number);
    text.lines(post_.acceleration.set);
}

void FeedWords::forget() {
    forget_value();
    mode_ = initial_mode();
    acceleration_increments_ = kUnknownIncrements;
}

}  // namespace gsim::codegen
