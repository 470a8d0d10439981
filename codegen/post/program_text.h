#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "codegen/post/gcode_numbers.h"
#include "codegen/post/post.h"

namespace gsim::codegen {

/// Text of a program, block by block: numbers of blocks, spaces between words, and the lines of a post.
class ProgramText {
  public:
    /// Consumer of the text in parts of some 64 KB.
    using Sink = std::function<void(std::string_view)>;

    /// `post` must outlive this.
    ProgramText(const Post& post, Sink sink) : post_(post), sink_(std::move(sink)) {}

    /// Returns the values of {number}, {title} and the other placeholders of the templates.
    PlaceholderValues& placeholders() { return placeholders_; }
    const PlaceholderValues& placeholders() const { return placeholders_; }
    /// Writes lines of a post with their placeholders filled in. They are numbered unless they begin with %,
    /// O, o or (.
    void lines(const std::vector<std::string>& templates);
    /// Writes a line of a post, as a block, with these values instead of those of placeholders().
    void block(std::string_view line, const PlaceholderValues& values);
    void comment(std::string_view text);

    /// Begins a block, with its number.
    void begin();
    /// Begins a line that has no number.
    void begin_unnumbered() { first_word_ = true; }
    /// Writes words, with a leading space unless they begin the line.
    void code(std::string_view text);
    /// Writes a word: its letter, and a number in increments of the format.
    void word(std::string_view letter, std::int64_t increments, const DecimalFormat& format);
    void word(char letter, std::int64_t increments, const DecimalFormat& format) {
        word({&letter, 1}, increments, format);
    }
    void end();
    /// Returns how many blocks have begun.
    std::uint64_t begun() const { return begun_; }
    /// Passes the remaining text on.
    void flush();

  private:
    const Post& post_;
    Sink sink_;
    PlaceholderValues placeholders_;
    fmt::memory_buffer text_;
    bool first_word_ = true;
    std::uint64_t begun_ = 0;
    std::uint64_t number_ = 0;
};

/// Returns a comment's text in the form for programs: ASCII without brackets.
std::string comment_text(std::string_view text);

}  // namespace gsim::codegen
