#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/plane.h"
#include "base/units.h"
#include "codegen/post/action_words.h"
#include "codegen/post/gcode_numbers.h"
#include "codegen/post/post.h"

namespace gsim::codegen {

/// Axis of the machine of a program.
struct WrittenAxis {
    char letter = 'X';
    bool rotary = false;  ///< In deg, otherwise mm.
};

/// Words of an arc in addition to its end.
struct ArcWords {
    Plane plane = Plane::xy;
    bool clockwise = false;                    ///< Seen from the positive end of the axis it turns about.
    std::array<double, 3> center_offset_mm{};  ///< From the start, along X, Y and Z.
    double turn_rad = 0;                       ///< Angle of the turn.
    int turns = 1;  ///< Circles that it begins; more than one only of a post that has a word for it.
};

/// Feed rate. If the controller supports it, it is written in the form of its origin.
struct WrittenFeed {
    double per_min = 0;                     ///< mm or deg
    bool rotary = false;                    ///< In deg/min: rotary axes alone move.
    std::optional<double> duration_s = {};  ///< For the full move.
    std::optional<double> per_rev_mm = {};  ///< In a turn of the spindle.
    std::optional<double> lead_mm = {};     ///< Lead per turn of a line in step with the spindle.
};

/// Straight path along an axis until the tool touches something, by which a work offset is found.
struct WrittenTouch {
    char axis = 'Z';
    std::array<double, 3> from_mm{};  ///< Start point.
    double to_mm = 0;                 ///< Max end position.
    double contact_mm = 0;            ///< New value of the axis at the touch.
    double feed_mm_min = 0;
};

struct WriterOptions {
    bool inch = false;
    bool verbose_words = false;           ///< Words are written though they have not changed.
    bool feed_modes = false;              ///< The program has feeds of several kinds.
    std::optional<int> decimals_mm = {};  ///< Replaces the post's.
    bool machine_coordinates = false;     ///< Numbers are machine coordinates, by the post's word for that.
};

/// Writer of blocks of G-code by a post. Words without new content are left out; it compares the printed
/// text, not the exact values. It receives values of axes and computes no kinematics.
class GcodeWriter {
  public:
    /// Consumer of the text in parts of some 64 KB.
    using Sink = std::function<void(std::string_view)>;

    /// Makes a writer; `post` must outlive it. One of the axes must be X, one Y and one Z for arcs.
    GcodeWriter(const Post& post, std::span<const WrittenAxis> axes, const WriterOptions& options, Sink sink);

    /// Returns the values of {number}, {title} and the other placeholders of the templates.
    PlaceholderValues& placeholders() { return placeholders_; }
    /// Writes lines of a post with their placeholders filled in. They are numbered unless they begin with %,
    /// O, o or (.
    void lines(const std::vector<std::string>& templates);
    /// Writes a block that assigns these coordinates to the present position of the machine, by a word such
    /// as G92.
    void preset(std::string_view word, std::span<const double> values);
    /// Sets the position of the axes, though no block has moved them there.
    void set_position(std::span<const double> values);
    /// Sets the active work coordinate system.
    void set_active_offset(const std::string& name);
    /// Writes the post's block that selects a work coordinate system; no block if it is active.
    void work_offset(const std::string& name);
    /// Writes the post's block that sets the origin of a work coordinate system; the post must have one.
    void set_work_offset(const std::string& name, const std::array<double, 3>& origin_mm);
    /// Writes a rapid of Z alone to a machine coordinate, if the post has a word for it. After it all axes
    /// are written again.
    void retract(double z_mm);
    /// Writes the post's blocks that find by a touch the origin of a work offset, which is active; the post
    /// must have some. The tool, which is up, comes down to the start of the touch, and returns there after
    /// it.
    void touch(const std::string& system, const WrittenTouch& touch);
    /// Writes rapids of some axes each, by letter, to machine coordinates; the post must have a word for
    /// them. After them all axes are written again.
    void machine_rapids(const std::vector<std::map<char, double>>& steps);
    /// Writes the same to a reference point, from 1, by the post's words for it; it must have this one. Only
    /// the letters of the steps are used.
    void move_to_reference(int number, const std::vector<std::map<char, double>>& steps);
    /// Writes a rapid (without feed) or linear move to these values, one for each axis. Writes no block if no
    /// word would change.
    void move(std::span<const double> values, const std::optional<WrittenFeed>& feed);
    /// Writes an arc or helix; a full circle ends at its start.
    void arc(std::span<const double> values, const ArcWords& words, const WrittenFeed& feed);
    /// Writes an arc through a point, given by its X, Y and Z. Only for a post that has words for it.
    void arc_through(std::span<const double> values, const std::array<double, 3>& via_mm,
                     const WrittenFeed& feed, double turn_rad = 0);
    void dwell(double seconds);
    /// Writes the post's blocks for an acceleration; no block if it has no such words, or if the same one is
    /// active.
    void acceleration(double mm_s2);
    /// Writes the post's block for the action, or a comment if it has no block.
    void action(std::string_view name);
    void comment(std::string_view text);
    /// Clears the active words, because another program begins, or one has been called.
    void forget();
    /// Passes the remaining text on.
    void flush();

    std::uint64_t blocks() const { return blocks_; }

  private:
    static constexpr std::int64_t kUnknown = INT64_MIN;
    static constexpr int kNoMotion = -1;  // of G00 to G03 that is known to be in force

    void machine_block(const std::map<char, double>& axes);
    void rapid_block(std::string_view letters, const std::array<double, 3>& xyz_mm);
    std::string length_text(double mm) const;
    std::string system_index(const std::string& system) const;
    void begin_block();
    void end_block();
    void code(std::string_view text);
    void word(char letter, std::int64_t units, const DecimalFormat& format);
    enum class FeedMode { unknown, per_minute, inverse_time, per_revolution };

    void begin_motion();
    bool motion_word(int motion);
    void thread(std::span<const double> values, const WrittenFeed& feed);
    FeedMode feed_mode_for(const WrittenFeed& feed) const;
    void feed_mode_word(FeedMode mode);
    void inverse_time_word(double per_min);
    bool axis_words(std::span<const double> values);
    void feed_word(const WrittenFeed& feed, double turn_rad);
    void plane_word(Plane plane);
    double in_unit(double mm) const { return options_.inch ? mm / kMmPerInch : mm; }
    std::int64_t units(std::size_t axis, double value) const;
    std::int64_t set_position(std::size_t axis, double value);
    const DecimalFormat& format(std::size_t axis) const { return axes_[axis].rotary ? deg_ : length_; }

    const Post& post_;
    ActionWords actions_;
    std::vector<WrittenAxis> axes_;
    WriterOptions options_;
    Sink sink_;
    PlaceholderValues placeholders_;
    DecimalFormat length_, deg_, feed_;
    fmt::memory_buffer text_;
    std::size_t block_begin_ = 0;  // in text_
    bool first_word_ = true;
    std::uint64_t blocks_ = 0;
    std::uint64_t number_ = 0;
    std::vector<std::int64_t> at_;  // printed units of each axis
    std::vector<double>
        rounding_residuals_;  // of each axis: its value less the printed one, in the program's unit
    std::int64_t machine_z_ =
        kUnknown;  // printed units, if the last block has moved to a position of the machine
    int motion_ = kNoMotion;
    int plane_ = -1;
    std::int64_t feed_units_ = kUnknown;
    FeedMode feed_mode_ = FeedMode::unknown;
    std::string system_;                   // the work coordinate system in force; empty: not known
    std::vector<std::string> next_words_;  // for the block of the next motion
    std::int64_t acceleration_units_ = kUnknown;
};

/// Returns a comment's text in the form for programs: ASCII without brackets.
std::string comment_text(std::string_view text);

}  // namespace gsim::codegen
