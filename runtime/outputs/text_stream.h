#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace gsim::simulation {

/// Buffered text for the caller. Text that follows a part that could not be written is dropped.
class TextStream {
  public:
    /// Function that writes a part; false: it cannot be written.
    using Sink = std::function<bool(std::string_view)>;

    explicit TextStream(Sink sink) : sink_(std::move(sink)) {}
    TextStream(const TextStream&) = delete;
    TextStream& operator=(const TextStream&) = delete;

    /// Returns the buffer to append to; call end_line() now and then.
    fmt::memory_buffer& buffer() { return buffer_; }
    /// Appends a line feed and passes the buffer on when it is large enough.
    void end_line() {
        buffer_.push_back('\n');
        if (buffer_.size() >= kEnough) write();
    }
    /// Returns true if a part could not be written.
    bool failed() const { return failed_; }
    /// Passes on the remainder.
    void flush() { write(); }

  private:
    static constexpr std::size_t kEnough = std::size_t{1} << 16;

    void write() {
        failed_ = failed_ || !sink_({buffer_.data(), buffer_.size()});
        buffer_.clear();
    }

    Sink sink_;
    fmt::memory_buffer buffer_;
    bool failed_ = false;
};

}  // namespace gsim::simulation
