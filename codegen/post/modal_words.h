#pragma once

#include "base/plane.h"
#include "codegen/post/program_text.h"

namespace gsim::codegen {

/// Motion of a block, as its G word.
enum class MotionWord { rapid, linear, clockwise, counterclockwise };

/// Modal words of motion (G00 to G03) and of the plane (G17 to G19). A word that is active is left out.
class ModalWords {
  public:
    /// `verbose`: words are written though they are active.
    explicit ModalWords(bool verbose) : verbose_(verbose) {}

    void write_motion(ProgramText& block, MotionWord motion);
    void write_plane(ProgramText& block, Plane plane);
    /// Clears the motion, because another word of its group is active or it shall be written.
    void forget_motion() { motion_ = kUnknown; }
    void forget() { motion_ = plane_ = kUnknown; }

  private:
    static constexpr int kUnknown = -1;

    bool verbose_;
    int motion_ = kUnknown;
    int plane_ = kUnknown;
};

}  // namespace gsim::codegen
