#include "codegen/post/gcode_writer.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/text/format.h"
#include "base/units.h"

namespace gsim::codegen {

namespace {

constexpr std::size_t kEnough = std::size_t{1} << 16;
constexpr std::uint64_t kMaxNumber = 99'999;
constexpr int kSignificantDigits = 7;
constexpr int kDecimals = 6;  // of numbers that are no positions
constexpr double kUnitsPerMm = 1e6;

constexpr std::array<std::string_view, 4> kMotions = {"G00", "G01", "G02", "G03"};
constexpr std::array<std::string_view, 3> kPlanes = {"G17", "G18", "G19"};
constexpr std::array<char, 3> kCenterLetters = {'I', 'J', 'K'};

// Axes of X, Y, Z in each plane, by index.
constexpr std::array<std::array<std::size_t, 2>, 3> kInPlane = {{{0, 1}, {0, 2}, {1, 2}}};

bool is_numbered(std::string_view line) {
    return line.empty() || std::string_view("%Oo(").find(line[0]) == std::string_view::npos;
}

}  // namespace

std::string comment_text(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        if (c == '(' || c == ')' || c == ';') continue;
        const auto byte = static_cast<unsigned char>(c);
        out += byte >= 0x20 && byte < 0x7f ? c : '?';
    }
    return out;
}

GcodeWriter::GcodeWriter(const Post& post, std::span<const WrittenAxis> axes, const WriterOptions& options,
                         Sink sink)
    : post_(post),
      actions_(post.actions),
      axes_(axes.begin(), axes.end()),
      options_(options),
      sink_(std::move(sink)),
      length_(options.inch ? post.decimals_inch : options.decimals_mm.value_or(post.decimals_mm), post.zeros),
      deg_(post.decimals_deg, post.zeros),
      feed_(post.decimals_feed, post.zeros),
      at_(axes.size(), kUnknown),
      rounding_residuals_(axes.size(), 0),
      feed_mode_(options.feed_modes ? FeedMode::unknown : FeedMode::per_minute) {}

std::int64_t GcodeWriter::units(std::size_t axis, double value) const {
    return axes_[axis].rotary ? deg_.units(value) : length_.units(in_unit(value));
}

void GcodeWriter::begin_block() {
    machine_z_ = kUnknown;
    block_begin_ = text_.size();
    first_word_ = true;
    if (post_.number_step == 0) return;
    number_ += static_cast<std::uint64_t>(post_.number_step);
    if (number_ > kMaxNumber) number_ = static_cast<std::uint64_t>(post_.number_step);
    text_.push_back('N');
    const fmt::format_int digits(number_);
    for (auto digit_count = static_cast<int>(digits.size()); digit_count < post_.number_digits;
         ++digit_count) {
        text_.push_back('0');
    }
    text_.append(digits.data(), digits.data() + digits.size());
    first_word_ = false;
}

void GcodeWriter::end_block() {
    text_.push_back('\n');
    ++blocks_;
    if (text_.size() >= kEnough) flush();
}

void GcodeWriter::flush() {
    sink_({text_.data(), text_.size()});
    text_.clear();
}

void GcodeWriter::code(std::string_view text) {
    if (!first_word_) text_.push_back(' ');
    first_word_ = false;
    text_.append(text.data(), text.data() + text.size());
}

void GcodeWriter::word(char letter, std::int64_t units, const DecimalFormat& format) {
    code({&letter, 1});
    format.append(text_, units);
}

void GcodeWriter::lines(const std::vector<std::string>& templates) {
    for (const std::string& each : templates) {
        const std::string line = fill_template(each, placeholders_);
        if (is_numbered(line))
            begin_block();
        else
            first_word_ = true;
        code(line);
        end_block();
    }
}

void GcodeWriter::forget() {
    machine_z_ = kUnknown;
    std::fill(at_.begin(), at_.end(), kUnknown);
    motion_ = kNoMotion;
    plane_ = -1;
    feed_units_ = kUnknown;
    feed_mode_ = options_.feed_modes ? FeedMode::unknown : FeedMode::per_minute;
    system_.clear();
    next_words_.clear();
    acceleration_units_ = kUnknown;
    std::fill(rounding_residuals_.begin(), rounding_residuals_.end(), 0);
}

// Writes the words that were deferred to this block.
void GcodeWriter::begin_motion() {
    begin_block();
    for (const std::string& word : next_words_) code(word);
    next_words_.clear();
}

bool GcodeWriter::motion_word(int motion) {
    const bool changes = motion_ != motion;
    motion_ = motion;
    if (changes || options_.verbose_words) code(kMotions[static_cast<std::size_t>(motion)]);
    return changes;
}

// Returns the printed value, and keeps its remainder.
std::int64_t GcodeWriter::set_position(std::size_t axis, double value) {
    const std::int64_t printed_units = units(axis, value);
    rounding_residuals_[axis] =
        (axes_[axis].rotary ? value : in_unit(value)) - format(axis).value(printed_units);
    return printed_units;
}

bool GcodeWriter::axis_words(std::span<const double> values) {
    bool changes = false;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::int64_t next = set_position(i, values[i]);
        if (next == at_[i] && !options_.verbose_words) continue;
        changes = changes || next != at_[i];
        at_[i] = next;
        word(axes_[i].letter, next, format(i));
    }
    return changes;
}

GcodeWriter::FeedMode GcodeWriter::feed_mode_for(const WrittenFeed& feed) const {
    if (feed.duration_s && !post_.feed_modes.inverse_time.empty()) return FeedMode::inverse_time;
    if (feed.per_rev_mm && !post_.feed_modes.per_revolution.empty()) return FeedMode::per_revolution;
    return FeedMode::per_minute;
}

// An F of one mode has no meaning in another.
void GcodeWriter::feed_mode_word(FeedMode mode) {
    if (mode == feed_mode_) return;
    feed_mode_ = mode;
    feed_units_ = kUnknown;
    const FeedModes& words = post_.feed_modes;
    switch (mode) {
        case FeedMode::inverse_time: return code(words.inverse_time);
        case FeedMode::per_revolution: return code(words.per_revolution);
        default: return code(words.per_minute);
    }
}

// F is written in each block, with the digits that short and long times need.
void GcodeWriter::inverse_time_word(double per_min) {
    const int integer_digits = static_cast<int>(std::ceil(std::log10(per_min)));
    code("F" + trimmed(per_min, std::clamp(kSignificantDigits - integer_digits, 3, 12)));
}

void GcodeWriter::feed_word(const WrittenFeed& feed, double turn_rad) {
    const FeedMode mode = feed_mode_for(feed);
    if (mode == FeedMode::inverse_time) {
        const bool by_angle = post_.feed_modes.inverse_time_by_angle && turn_rad > 0;
        return inverse_time_word((by_angle ? turn_rad : 1) * kSecondsPerMinute / *feed.duration_s);
    }
    if (mode == FeedMode::per_revolution) {
        const double per_rev = in_unit(*feed.per_rev_mm);
        const std::int64_t next = std::llround(per_rev * kUnitsPerMm);
        if (next != feed_units_) code("F" + trimmed(per_rev, kDecimals));
        feed_units_ = next;
        return;
    }
    // A feed that rounds to 0 would never reach the target.
    const std::int64_t next =
        std::max<std::int64_t>(1, feed_.units(feed.rotary ? feed.per_min : in_unit(feed.per_min)));
    if (next == feed_units_ && !options_.verbose_words) return;
    feed_units_ = next;
    word('F', next, feed_);
}

void GcodeWriter::plane_word(Plane plane) {
    const int index = static_cast<int>(plane);
    if (index == plane_ && !options_.verbose_words) return;
    plane_ = index;
    code(kPlanes[static_cast<std::size_t>(index)]);
}

void GcodeWriter::move(std::span<const double> values, const std::optional<WrittenFeed>& feed) {
    bool changes = false;
    for (std::size_t i = 0; i < axes_.size(); ++i) changes = set_position(i, values[i]) != at_[i] || changes;
    if (!changes) return;
    if (feed && feed->lead_mm) return thread(values, *feed);
    begin_motion();
    if (options_.machine_coordinates) code(post_.offsets.machine);
    if (feed) feed_mode_word(feed_mode_for(*feed));
    motion_word(feed ? 1 : 0);
    axis_words(values);
    if (feed) feed_word(*feed, 0);
    end_block();
}

void GcodeWriter::thread(std::span<const double> values, const WrittenFeed& feed) {
    begin_motion();
    code(post_.thread);
    motion_ = kNoMotion;
    axis_words(values);
    if (post_.thread_lead == "F") feed_units_ = kUnknown;
    code(post_.thread_lead + trimmed(in_unit(*feed.lead_mm), kDecimals));
    end_block();
}

void GcodeWriter::arc(std::span<const double> values, const ArcWords& words, const WrittenFeed& feed) {
    begin_motion();
    plane_word(words.plane);
    feed_mode_word(feed_mode_for(feed));
    motion_word(words.clockwise ? 2 : 3);
    const std::array<std::size_t, 2>& in_plane = kInPlane[static_cast<std::size_t>(words.plane)];
    const auto axis_index = [this](std::size_t direction) {
        const char letter = static_cast<char>('X' + direction);
        const auto found = std::find_if(axes_.begin(), axes_.end(),
                                        [letter](const WrittenAxis& axis) { return axis.letter == letter; });
        return static_cast<std::size_t>(found - axes_.begin());
    };
    const bool full_circle = std::all_of(in_plane.begin(), in_plane.end(), [&](std::size_t direction) {
        const std::size_t axis = axis_index(direction);
        return units(axis, values[axis]) == at_[axis];
    });
    // Some controllers need a word of the plane to recognise the block as an arc.
    if (full_circle) {
        for (const std::size_t direction : in_plane) at_[axis_index(direction)] = kUnknown;
    }
    std::array<std::int64_t, 3> offsets{};
    for (const std::size_t direction : in_plane) {
        // Relative to the printed start, so that the error of the centre is only its own rounding.
        offsets[direction] = length_.units(in_unit(words.center_offset_mm[direction]) +
                                           rounding_residuals_[axis_index(direction)]);
    }
    axis_words(values);
    for (const std::size_t direction : in_plane) word(kCenterLetters[direction], offsets[direction], length_);
    if (words.turns > 1) code(fmt::format("{}{}", post_.arc_turns_letter, words.turns));
    feed_word(feed, words.turn_rad);
    end_block();
}

// The point is written in full, because it distinguishes the circle from all others through the ends.
void GcodeWriter::arc_through(std::span<const double> values, const std::array<double, 3>& via_mm,
                              const WrittenFeed& feed, double turn_rad) {
    const ThroughPoint& words = *post_.through_point;
    begin_motion();
    feed_mode_word(feed_mode_for(feed));
    motion_ = kNoMotion;
    code(words.code);
    axis_words(values);
    for (std::size_t i = 0; i < via_mm.size(); ++i) {
        code(words.letters[i]);
        length_.append(text_, length_.units(in_unit(via_mm[i])));
    }
    feed_word(feed, turn_rad);
    end_block();
}

// A time is written to the thousandth, or as exactly as it is given if lengths have digits of their own.
void GcodeWriter::dwell(double seconds) {
    const bool is_short_dwell = std::abs(seconds * 1000 - std::round(seconds * 1000)) < 1e-6;
    const bool is_exact = options_.decimals_mm && !is_short_dwell;
    if (!is_exact && seconds > 0) seconds = std::max(seconds, 0.001);
    PlaceholderValues placeholders = placeholders_;
    placeholders["seconds"] = fmt::format("{:.{}f}", seconds, is_exact ? 6 : 3);
    placeholders["milliseconds"] = fmt::format("{:.{}f}", seconds * 1000, is_exact ? 3 : 0);
    begin_block();
    code(fill_template(post_.dwell, placeholders));
    end_block();
}

void GcodeWriter::acceleration(double mm_s2) {
    if (post_.acceleration.empty()) return;
    const std::int64_t next = std::max<std::int64_t>(1, feed_.units(in_unit(mm_s2)));
    if (next == acceleration_units_ && !options_.verbose_words) return;
    acceleration_units_ = next;
    fmt::memory_buffer number;
    feed_.append(number, next);
    placeholders_["acceleration"] = fmt::to_string(number);
    lines(post_.acceleration);
}

void GcodeWriter::action(std::string_view name) {
    if (name == kStandstillAction) return dwell(0);
    const auto block = actions_.find_block(name, options_.inch ? kMmPerInch : 1);
    if (!block) return comment(fmt::format("action: {}", name));
    if (block->empty()) return;
    if (block->ends_with(kInNextBlock)) {
        next_words_.push_back(block->substr(0, block->size() - kInNextBlock.size()));
        return;
    }
    const bool is_comment = block->front() == '(';
    if (is_comment) {
        first_word_ = true;
    } else {
        begin_block();
    }
    code(*block);
    end_block();
}

void GcodeWriter::comment(std::string_view text) {
    text::append_format(text_, "({})", comment_text(text));
    end_block();
}

}  // namespace gsim::codegen
