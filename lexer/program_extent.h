#pragma once

#include <cstdint>

namespace gsim::lexer {

/// Parts of a source that are not read: the leader of a tape, the text past the end of the main program, and
/// the text past the end of the tape.
class ProgramExtent {
  public:
    /// Treats the first lines of the source as remarks. To be called before the first token.
    void skip_leader(std::uint32_t lines) { leader_lines_ = lines; }
    bool is_in_leader(std::uint32_t line) const { return line <= leader_lines_; }

    /// Ends the main program (RS274/NGC: M2 or M30); the text that follows is read only from the next O-word
    /// on.
    void end_main_program() { main_ended_ = true; }
    /// Goes on with a program after that end.
    void resume() { main_ended_ = false; }
    bool has_main_ended() const { return main_ended_; }

    void add_tape_mark() { ++tape_marks_; }
    /// Returns true from the second tape mark on.
    bool has_tape_ended() const { return tape_marks_ == 2; }

    /// Ends the file by the byte 0x1A, as DOS does.
    void end_dos_file() { dos_file_ended_ = true; }
    bool has_dos_file_ended() const { return dos_file_ended_; }

  private:
    std::uint32_t leader_lines_ = 0;
    int tape_marks_ = 0;
    bool main_ended_ = false;
    bool dos_file_ended_ = false;
};

}  // namespace gsim::lexer
