#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>

namespace gsim::apps {

/// A progress bar in one line of a terminal, drawn at most a few times a second and erased at the end; no
/// output if the stream is no terminal.
class Progress {
  public:
    /// Draws on `stream`, which must outlive this object, if it is a terminal.
    explicit Progress(std::FILE* stream = stderr);
    Progress(std::FILE* stream, bool enabled) : stream_(stream), enabled_(enabled) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }

    /// Shows the progress; cheap enough for frequent calls. `total` 0: not known.
    void update(std::uint64_t done, std::uint64_t total);
    /// Erases the line, so that other text can be written.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    void draw(std::uint64_t done, std::uint64_t total);

    std::FILE* stream_;
    bool enabled_;
    bool is_drawn_ = false;
    Clock::time_point next_ = {};
};

}  // namespace gsim::apps
