#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>

namespace gsim::apps {

/// A progress bar in one line of a terminal, drawn a few times a second at most and wiped at the end; nothing
/// at all where the stream is no terminal.
class Progress {
  public:
    /// `stream`, which must outlive this, is drawn on if it is a terminal.
    explicit Progress(std::FILE* stream = stderr);
    Progress(std::FILE* stream, bool enabled) : stream_(stream), enabled_(enabled) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }

    /// Cheap enough to be called often. `total` 0: not known.
    void update(std::uint64_t done, std::uint64_t total);
    /// Wipes the line, so that something else can be written.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    void draw(std::uint64_t done, std::uint64_t total);

    std::FILE* stream_;
    bool enabled_;
    bool drawn_ = false;
    Clock::time_point next_ = {};
};

}  // namespace gsim::apps
