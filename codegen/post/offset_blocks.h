#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "codegen/post/axis_words.h"
#include "codegen/post/feed_words.h"
#include "codegen/post/modal_words.h"
#include "codegen/post/post.h"
#include "codegen/post/program_text.h"

namespace gsim::codegen {

/// Straight path along an axis until the tool touches something, by which a work offset is found.
struct ProbeTouch {
    char axis = 'Z';
    std::array<double, 3> from_mm{};  ///< Start point.
    double to_mm = 0;                 ///< Max end position.
    double contact_mm = 0;            ///< New value of the axis at the touch.
    double feed_mm_min = 0;
};

/// Blocks that set the reference of positions: work coordinate systems and the present position.
class OffsetBlocks {
  public:
    /// All must outlive this.
    OffsetBlocks(const Post& post, ProgramText& text, AxisWords& axes, ModalWords& modal, FeedWords& feed)
        : post_(post), text_(text), axes_(axes), modal_(modal), feed_(feed) {}

    /// Writes a block that assigns these coordinates to the present position of the machine, by a word such
    /// as G92.
    void preset(std::string_view word, std::span<const double> values);
    /// Sets the active work coordinate system, though no block has selected it.
    void set_active(const std::string& name) { active_ = name; }
    /// Writes the post's block that selects a work coordinate system; no block if it is active.
    void select(const std::string& name);
    /// Writes the post's block that sets the origin of a work coordinate system; the post must have one.
    void set_origin(const std::string& name, const std::array<double, 3>& origin_mm);
    /// Writes the post's blocks that find by a touch the origin of a work offset, which is active; the post
    /// must have some. The tool, which is up, comes down to the start of the touch, and then returns there.
    void touch(const std::string& system, const ProbeTouch& touch);
    void forget() { active_.clear(); }

  private:
    void rapid_block(std::string_view letters, const std::array<double, 3>& xyz_mm);
    std::string system_index(const std::string& system) const;

    const Post& post_;
    ProgramText& text_;
    AxisWords& axes_;
    ModalWords& modal_;
    FeedWords& feed_;
    std::string active_;  ///< Active work coordinate system; empty: not known.
};

}  // namespace gsim::codegen
