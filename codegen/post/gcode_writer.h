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

/// An axis of the machine that a program is for.
struct WrittenAxis {
    char letter = 'X';
    bool rotary = false;  ///< In deg, otherwise mm.
};

/// What an arc says beyond its end.
struct ArcWords {
    Plane plane = Plane::xy;
    bool clockwise = false;                    ///< Seen from the positive end of the axis it turns about.
    std::array<double, 3> center_offset_mm{};  ///< From the start, along X, Y and Z.
    double turn_rad = 0;                       ///< How far it turns.
    int turns = 1;  ///< Circles that it begins; more than one only of a post that has a word for it.
};

/// A feed rate. Where the control can be told so, it is written as what it comes from.
struct WrittenFeed {
    double per_min = 0;                     ///< mm or deg
    bool rotary = false;                    ///< In deg/min: rotary axes alone move.
    std::optional<double> duration_s = {};  ///< Of the whole move.
    std::optional<double> per_rev_mm = {};  ///< In a turn of the spindle.
    std::optional<double> lead_mm = {};     ///< Of a line in step with the spindle, in a turn.
};

/// A straight way along an axis until the tool touches something, by which a work offset is found.
struct WrittenTouch {
    char axis = 'Z';
    std::array<double, 3> from_mm{};  ///< Where it begins.
    double to_mm = 0;                 ///< Where it ends at most.
    double contact_mm = 0;            ///< What the axis shall have where the touch is.
    double feed_mm_min = 0;
};

struct WriterOptions {
    bool inch = false;
    bool verbose_words = false;           ///< Words are written though they have not changed.
    bool feed_modes = false;              ///< The program has feeds of several kinds.
    std::optional<int> decimals_mm = {};  ///< In place of the post's.
    bool in_machine = false;              ///< Numbers are machine coordinates, by the post's word for that.
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
    /// A block that gives the place where the machine stands these coordinates, by a word such as G92.
    void here(std::string_view word, std::span<const double> values);
    /// The axes stand there, though no block has led there.
    void stand(std::span<const double> values);
    /// A work coordinate system is in force.
    void begin_in(const std::string& name);
    /// The post's block that selects a work coordinate system; nothing where it is in force.
    void work_offset(const std::string& name);
    /// The post's block that says where a work coordinate system lies; the post must have one.
    void set_work_offset(const std::string& name, const std::array<double, 3>& origin_mm);
    /// A rapid of Z alone to a machine coordinate, where the post has a word for these. Behind it all axes
    /// are written again.
    void retract(double z_mm);
    /// The post's blocks that find by a touch where a work offset lies, which is in force; the post must have
    /// some. The tool, which is up, comes down to the beginning of the touch, and goes back there behind it.
    void touch(const std::string& system, const WrittenTouch& touch);
    /// Rapids of some axes each, by letter, to machine coordinates; the post must have a word for these.
    /// Behind them all axes are written again.
    void machine_rapids(const std::vector<std::map<char, double>>& steps);
    /// The same to a reference point, from 1, by the post's words for it, of which it must have this one. Of
    /// the steps the letters count.
    void go_to_reference(int number, const std::vector<std::map<char, double>>& steps);
    /// A rapid (without feed) or linear move to these values, one for each axis. Nothing is written where no
    /// word would change.
    void move(std::span<const double> values, const std::optional<WrittenFeed>& feed);
    /// An arc or helix; a full circle ends where it starts.
    void arc(std::span<const double> values, const ArcWords& words, const WrittenFeed& feed);
    /// An arc through a point, whose X, Y and Z are given. Only of a post that has words for it.
    void arc_through(std::span<const double> values, const std::array<double, 3>& via_mm,
                     const WrittenFeed& feed, double turn_rad = 0);
    void dwell(double seconds);
    /// The post's blocks for an acceleration; nothing where it has none, or where the same one is in force.
    void acceleration(double mm_s2);
    /// The post's block for the action, or a comment where it has none.
    void action(std::string_view name);
    void comment(std::string_view text);
    /// Forgets what words are in force: another program begins, or one has been called.
    void forget();
    /// Passes on what is left.
    void flush();

    std::uint64_t blocks() const { return blocks_; }

  private:
    static constexpr std::int64_t kUnknown = INT64_MIN;
    static constexpr int kNoMotion = -1;  // of G00 to G03 that is known to be in force

    void machine_block(const std::map<char, double>& axes);
    void rapid_block(std::string_view letters, const std::array<double, 3>& xyz_mm);
    std::string length_text(double mm) const;
    std::string index_of(const std::string& system) const;
    void begin_block();
    void end_block();
    void code(std::string_view text);
    void word(char letter, std::int64_t units, const DecimalFormat& format);
    enum class FeedMode { unknown, per_minute, inverse_time, per_revolution };

    void begin_motion();
    bool motion_word(int motion);
    void thread(std::span<const double> values, const WrittenFeed& feed);
    FeedMode mode_of(const WrittenFeed& feed) const;
    void feed_mode_word(FeedMode mode);
    void inverse_time_word(double per_min);
    bool axis_words(std::span<const double> values);
    void feed_word(const WrittenFeed& feed, double turn_rad);
    void plane_word(Plane plane);
    double in_unit(double mm) const { return options_.inch ? mm / kMmPerInch : mm; }
    std::int64_t units(std::size_t axis, double value) const;
    std::int64_t stand_at(std::size_t axis, double value);
    const DecimalFormat& format(std::size_t axis) const { return axes_[axis].rotary ? deg_ : length_; }

    const Post& post_;
    ActionWords actions_;
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
    std::int64_t machine_z_ =
        kUnknown;  // printed units, where the last block has led to a place of the machine
    int motion_ = kNoMotion;
    int plane_ = -1;
    std::int64_t feed_units_ = kUnknown;
    FeedMode feed_mode_ = FeedMode::unknown;
    std::string system_;                   // the work coordinate system in force; empty: not known
    std::vector<std::string> next_words_;  // that stand in the block of the next motion
    std::int64_t acceleration_units_ = kUnknown;
};

/// A comment's text as programs may hold it: ASCII without brackets.
std::string comment_text(std::string_view text);

}  // namespace gsim::codegen
