#pragma once

#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace gsim::simulation {

/// Buffered text on its way into a stream of the caller's. The first error of writing is kept and told by
/// flush(); what comes after it is dropped.
class TextStream {
  public:
    /// `file` must outlive this.
    explicit TextStream(std::FILE* file) : file_(file) {}
    TextStream(const TextStream&) = delete;
    TextStream& operator=(const TextStream&) = delete;

    /// Where to append; call end_line() now and then.
    fmt::memory_buffer& buffer() { return buffer_; }
    /// Appends a line feed and passes the buffer on when it is large enough.
    void end_line() {
        buffer_.push_back('\n');
        if (buffer_.size() >= kEnough) write();
    }
    /// Whether an error of writing has occurred.
    bool failed() const { return error_.has_value(); }
    /// Passes on all that is left. The error is errno of the first failure.
    tl::expected<void, int> flush();

  private:
    static constexpr std::size_t kEnough = std::size_t{1} << 16;

    void write();

    std::FILE* file_;
    fmt::memory_buffer buffer_;
    std::optional<int> error_;
};

}  // namespace gsim::simulation
