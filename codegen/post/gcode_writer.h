#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/plane.h"
#include "codegen/post/action_blocks.h"
#include "codegen/post/axis_words.h"
#include "codegen/post/feed_words.h"
#include "codegen/post/machine_blocks.h"
#include "codegen/post/modal_words.h"
#include "codegen/post/offset_blocks.h"
#include "codegen/post/post.h"
#include "codegen/post/program_text.h"

namespace gsim::codegen {

/// Words of an arc in addition to its end.
struct ArcWords {
    Plane plane = Plane::xy;
    bool clockwise = false;                    ///< Seen from the positive end of the axis it turns about.
    std::array<double, 3> center_offset_mm{};  ///< From the start, along X, Y and Z.
    double turn_rad = 0;                       ///< Angle of the turn.
    int turns = 1;  ///< Circles that it begins; more than one only of a post that has a word for it.
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
    using Sink = ProgramText::Sink;

    /// Makes a writer; `post` must outlive it. One of the axes must be X, one Y and one Z for arcs.
    GcodeWriter(const Post& post, std::span<const GcodeAxis> axes, const WriterOptions& options, Sink sink);
    GcodeWriter(const GcodeWriter&) = delete;
    GcodeWriter& operator=(const GcodeWriter&) = delete;

    /// Returns the text: the post's lines, comments, and what has not been passed on yet.
    ProgramText& text() { return text_; }
    AxisWords& axes() { return axes_; }
    OffsetBlocks& offsets() { return offsets_; }
    /// Returns the blocks that move to positions of the machine.
    MachineBlocks& machine() { return machine_; }

    /// Writes a rapid (without feed) or linear move to these values, one for each axis. Writes no block if no
    /// word would change.
    void move(std::span<const double> values, const std::optional<GcodeFeed>& feed);
    /// Writes an arc or helix; a full circle ends at its start.
    void arc(std::span<const double> values, const ArcWords& words, const GcodeFeed& feed);
    /// Writes an arc through a point, given by its X, Y and Z. Only for a post that has words for it.
    void arc_through(std::span<const double> values, const std::array<double, 3>& via_mm,
                     const GcodeFeed& feed, double turn_rad = 0);
    void dwell(double seconds);
    /// Writes the post's blocks for an acceleration; no block if it has no such words, or if the same one is
    /// active.
    void acceleration(double mm_s2) { feed_.write_acceleration(text_, mm_s2); }
    /// Writes the post's block for the action, or a comment if it has no block.
    void action(std::string_view name);
    /// Clears the active words, because another program begins, or one has been called.
    void forget();

  private:
    void begin_motion();
    void thread(std::span<const double> values, const GcodeFeed& feed);
    bool is_full_circle(std::span<const double> values, Plane plane) const;

    const Post& post_;
    ActionBlocks actions_;
    WriterOptions options_;
    ProgramText text_;
    AxisWords axes_;
    ModalWords modal_;
    FeedWords feed_;
    OffsetBlocks offsets_;
    MachineBlocks machine_;
    std::vector<std::string> next_words_;  ///< For the block of the next motion.
};

}  // namespace gsim::codegen
