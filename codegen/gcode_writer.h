#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "codegen/gcode_numbers.h"
#include "codegen/post.h"

namespace gsim::codegen {

/// An axis of the machine that a program is for.
struct WrittenAxis {
    char letter = 'X';
    bool rotary = false;  ///< In deg, otherwise mm.
};

/// The plane of an arc, by the axis that it turns about.
enum class ArcPlane { about_z, about_y, about_x };

/// What an arc says beyond its end.
struct ArcWords {
    ArcPlane plane = ArcPlane::about_z;
    bool clockwise = false;                    ///< Seen from the positive end of the axis it turns about.
    std::array<double, 3> center_offset_mm{};  ///< From the start, along X, Y and Z.
};

/// A feed rate.
struct WrittenFeed {
    double per_min = 0;   ///< mm or deg
    bool rotary = false;  ///< In deg/min: rotary axes alone move.
};

struct WriterOptions {
    bool inch = false;
    bool verbose_words = false;  ///< Words are written though they have not changed.
};

/// Writes blocks of G-code by a post. Words that say nothing new are left out; what counts is what is
/// printed, not the values behind it. It is handed values of axes and computes no kinematics.
class GcodeWriter {
  public:
    /// Takes the text in pieces of some 64 KB.
    using Sink = std::function<void(std::string_view)>;

    /// `post` must outlive the writer. One of the axes must be X, one Y and one Z for arcs.
    GcodeWriter(const Post& post, std::span<const WrittenAxis> axes, const WriterOptions& options, Sink sink);

    /// What {number}, {title} and the like of the templates stand for.
    Places& places() { return places_; }
    /// Lines of a post with their places filled in. They are numbered unless they begin with %, O, o or (.
    void lines(const std::vector<std::string>& templates);
    /// The block that names where the tool stands, if the post has one.
    void start_position(std::span<const double> values);
    /// A rapid (without feed) or linear move to these values, one for each axis. Nothing is written where no
    /// word would change.
    void move(std::span<const double> values, const std::optional<WrittenFeed>& feed);
    /// An arc or helix of one turn at most; a full circle ends where it starts.
    void arc(std::span<const double> values, const ArcWords& words, const WrittenFeed& feed);
    void dwell(double seconds);
    /// The post's blocks for an acceleration; nothing where it has none, or where the same one is in force.
    void acceleration(double mm_s2);
    /// The post's block for the action, or a comment.
    void action(std::string_view name);
    void comment(std::string_view text);
    /// Forgets what words are in force: another program begins, or one has been called.
    void forget();
    /// Begins to count blocks anew.
    void restart_numbers() { number_ = 0; }
    /// Passes on what is left.
    void flush();

    std::uint64_t blocks() const { return blocks_; }

  private:
    static constexpr std::int64_t kUnknown = INT64_MIN;

    void begin_block();
    void end_block();
    void code(std::string_view text);
    void word(char letter, std::int64_t units, const DecimalFormat& format);
    bool motion_word(int motion);
    bool axis_words(std::span<const double> values);
    void feed_word(const WrittenFeed& feed);
    void plane_word(ArcPlane plane);
    double in_unit(double mm) const { return options_.inch ? mm / 25.4 : mm; }
    std::int64_t units(std::size_t axis, double value) const;
    std::int64_t stand_at(std::size_t axis, double value);
    const DecimalFormat& format(std::size_t axis) const { return axes_[axis].rotary ? deg_ : length_; }

    const Post& post_;
    std::vector<WrittenAxis> axes_;
    WriterOptions options_;
    Sink sink_;
    Places places_;
    DecimalFormat length_, deg_, feed_;
    fmt::memory_buffer text_;
    std::size_t block_begin_ = 0;  // in text_
    bool first_word_ = true;
    std::uint64_t blocks_ = 0;
    std::uint64_t number_ = 0;
    std::vector<std::int64_t> at_;  // printed units of each axis
    std::vector<double> rest_;      // of each axis: its value less the printed one, in the program's unit
    int motion_ = -1;
    int plane_ = -1;
    std::int64_t feed_units_ = kUnknown;
    std::int64_t acceleration_units_ = kUnknown;
};

/// A comment's text as programs may hold it: ASCII without brackets.
std::string comment_text(std::string_view text);

}  // namespace gsim::codegen
