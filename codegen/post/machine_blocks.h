#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "codegen/post/axis_words.h"
#include "codegen/post/modal_words.h"
#include "codegen/post/post.h"
#include "codegen/post/program_text.h"

namespace gsim::codegen {

/// Blocks that move to positions of the machine. After them all axes are written again.
class MachineBlocks {
  public:
    /// All must outlive this.
    MachineBlocks(const Post& post, ProgramText& text, AxisWords& axes, ModalWords& modal)
        : post_(post), text_(text), axes_(axes), modal_(modal) {}

    /// Writes a rapid of Z alone to a machine coordinate, if the post has a word for it and the block before
    /// has not moved there.
    void retract(double z_mm);
    /// Writes rapids of some axes each, by letter, to machine coordinates; the post must have a word for
    /// them.
    void move(const std::vector<std::map<char, double>>& steps);
    /// Writes the same to a reference point, from 1, by the post's words for it; it must have this one. Only
    /// the letters of the steps are used.
    void move_to_reference(int number, const std::vector<std::map<char, double>>& steps);
    void forget() { z_increments_ = kUnknownIncrements; }

  private:
    void rapid(const std::map<char, double>& axes);
    /// Returns the machine coordinate of Z in printed increments, if the last block is of this class.
    std::int64_t z_increments() const {
        return text_.begun() == z_block_ ? z_increments_ : kUnknownIncrements;
    }

    const Post& post_;
    ProgramText& text_;
    AxisWords& axes_;
    ModalWords& modal_;
    std::int64_t z_increments_ = kUnknownIncrements;
    std::uint64_t z_block_ = 0;  ///< Number of the block after which z_increments_ is true.
};

}  // namespace gsim::codegen
