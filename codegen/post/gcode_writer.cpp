#include "codegen/post/gcode_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"

namespace gsim::codegen {

namespace {

constexpr std::array<char, 3> kCenterLetters = {'I', 'J', 'K'};

// Axes of X, Y, Z in each plane, by index.
constexpr std::array<std::array<std::size_t, 2>, 3> kPlaneAxisIndices = {{{0, 1}, {0, 2}, {1, 2}}};

const std::array<std::size_t, 2>& in_plane(Plane plane) {
    return kPlaneAxisIndices[static_cast<std::size_t>(plane)];
}

char letter_of(std::size_t direction) {
    return static_cast<char>('X' + direction);
}

DecimalFormat length_format(const Post& post, const WriterOptions& options) {
    return {
        options.inch ? post.numbers.decimals_inch : options.decimals_mm.value_or(post.numbers.decimals_mm),
        post.numbers.zeros};
}

}  // namespace

GcodeWriter::GcodeWriter(const Post& post, std::span<const GcodeAxis> axes, const WriterOptions& options,
                         Sink sink)
    : post_(post),
      actions_(post.actions),
      options_(options),
      text_(post, std::move(sink)),
      axes_(axes, length_format(post, options), {post.numbers.decimals_deg, post.numbers.zeros}, options.inch,
            options.verbose_words),
      modal_(options.verbose_words),
      feed_(post, {.inch = options.inch, .verbose = options.verbose_words, .feed_modes = options.feed_modes}),
      offsets_(post, text_, axes_, modal_, feed_),
      machine_(post, text_, axes_, modal_) {}

void GcodeWriter::forget() {
    axes_.forget();
    modal_.forget();
    feed_.forget();
    offsets_.forget();
    machine_.forget();
    next_words_.clear();
}

/// Writes the words that were deferred to this block.
void GcodeWriter::begin_motion() {
    text_.begin();
    for (const std::string& word : next_words_) text_.code(word);
    next_words_.clear();
}

void GcodeWriter::move(std::span<const double> values, const std::optional<GcodeFeed>& feed) {
    if (!axes_.would_change(values)) return;
    if (feed && feed->lead_mm) return thread(values, *feed);
    begin_motion();
    if (options_.machine_coordinates) text_.code(post_.offsets.machine);
    if (feed) feed_.write_mode(text_, *feed);
    modal_.write_motion(text_, feed ? MotionWord::linear : MotionWord::rapid);
    axes_.write(text_, values);
    if (feed) feed_.write(text_, *feed, 0);
    text_.end();
}

void GcodeWriter::thread(std::span<const double> values, const GcodeFeed& feed) {
    begin_motion();
    text_.code(post_.thread.code);
    modal_.forget_motion();
    axes_.write(text_, values);
    if (post_.thread.lead == "F") feed_.forget_value();
    text_.code(post_.thread.lead + trimmed(axes_.in_unit(*feed.lead_mm), kValueDecimals));
    text_.end();
}

bool GcodeWriter::is_full_circle(std::span<const double> values, Plane plane) const {
    return std::all_of(in_plane(plane).begin(), in_plane(plane).end(), [&](std::size_t direction) {
        const std::size_t axis = axes_.index_of(letter_of(direction));
        return axes_.is_at(axis, values[axis]);
    });
}

void GcodeWriter::arc(std::span<const double> values, const ArcWords& words, const GcodeFeed& feed) {
    begin_motion();
    modal_.write_plane(text_, words.plane);
    feed_.write_mode(text_, feed);
    modal_.write_motion(text_, words.clockwise ? MotionWord::clockwise : MotionWord::counterclockwise);
    // Some controllers need a word of the plane to recognise the block as an arc.
    if (is_full_circle(values, words.plane)) {
        for (const std::size_t direction : in_plane(words.plane))
            axes_.forget_position(axes_.index_of(letter_of(direction)));
    }
    std::array<std::int64_t, 3> offsets{};
    for (const std::size_t direction : in_plane(words.plane)) {
        // Relative to the printed start, so that the error of the centre is only its own rounding.
        offsets[direction] =
            axes_.length().increments(axes_.in_unit(words.center_offset_mm[direction]) +
                                      axes_.rounding_residual(axes_.index_of(letter_of(direction))));
    }
    axes_.write(text_, values);
    for (const std::size_t direction : in_plane(words.plane))
        text_.word(kCenterLetters[direction], offsets[direction], axes_.length());
    if (words.turns > 1) text_.code(fmt::format("{}{}", post_.arcs.turns_letter, words.turns));
    feed_.write(text_, feed, words.turn_rad);
    text_.end();
}

// The point is written in full, because it distinguishes the circle from all others through the ends.
void GcodeWriter::arc_through(std::span<const double> values, const std::array<double, 3>& via_mm,
                              const GcodeFeed& feed, double turn_rad) {
    const ThroughPointWords& words = *post_.arcs.through_point;
    begin_motion();
    feed_.write_mode(text_, feed);
    modal_.forget_motion();
    text_.code(words.code);
    axes_.write(text_, values);
    for (std::size_t i = 0; i < via_mm.size(); ++i)
        text_.word(words.letters[i], axes_.length_increments(via_mm[i]), axes_.length());
    feed_.write(text_, feed, turn_rad);
    text_.end();
}

// A time is written to the thousandth, or as exactly as it is given if lengths have digits of their own.
void GcodeWriter::dwell(double seconds) {
    const bool is_short_dwell = std::abs(seconds * 1000 - std::round(seconds * 1000)) < 1e-6;
    const bool is_exact = options_.decimals_mm && !is_short_dwell;
    if (!is_exact && seconds > 0) seconds = std::max(seconds, 0.001);
    PlaceholderValues placeholders = text_.placeholders();
    placeholders["seconds"] = fmt::format("{:.{}f}", seconds, is_exact ? 6 : 3);
    placeholders["milliseconds"] = fmt::format("{:.{}f}", seconds * 1000, is_exact ? 3 : 0);
    text_.block(post_.blocks.dwell, placeholders);
}

void GcodeWriter::action(std::string_view name) {
    if (name == kStandstillAction) return dwell(0);
    const auto block = actions_.find_block(name, options_.inch ? kMmPerInch : 1);
    if (!block) return text_.comment(fmt::format("action: {}", name));
    if (block->empty()) return;
    if (block->ends_with(kNextBlockSuffix)) {
        next_words_.push_back(block->substr(0, block->size() - kNextBlockSuffix.size()));
        return;
    }
    const bool is_comment = block->front() == '(';
    if (is_comment) {
        text_.begin_unnumbered();
    } else {
        text_.begin();
    }
    text_.code(*block);
    text_.end();
}

}  // namespace gsim::codegen
