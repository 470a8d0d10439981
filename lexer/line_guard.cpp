#include "lexer/line_guard.h"

#include <algorithm>
#include <cstring>

namespace gsim::lexer {

std::size_t LineGuard::fill(char* buffer, std::size_t capacity) {
    while (const std::size_t count = source_.read(buffer, capacity)) {
        std::size_t out = 0;
        for (std::size_t in = 0; in < count;) {
            const auto* end = static_cast<const char*>(std::memchr(buffer + in, '\n', count - in));
            const std::size_t size =
                end == nullptr ? count - in : static_cast<std::size_t>(end - (buffer + in));
            const std::size_t space_left = kMaxLineBytes - std::min(kMaxLineBytes, read_line_bytes_);
            const std::size_t kept = std::min(size, space_left);
            if (out != in) std::memmove(buffer + out, buffer + in, kept);
            out += kept;
            read_line_bytes_ += size;
            if (kept < size) {
                if (truncated_lines_.empty() || truncated_lines_.back().line != read_line_)
                    truncated_lines_.push_back({read_line_, 0});
                truncated_lines_.back().dropped_bytes += size - kept;
            }
            in += size;
            if (end != nullptr) {
                buffer[out++] = '\n';
                ++in;
                ++read_line_;
                read_line_bytes_ = 0;
            }
        }
        if (out > 0) return out;
    }
    return 0;
}

std::optional<std::uint64_t> LineGuard::release_cut(std::uint32_t line) {
    if (truncated_lines_.empty() || truncated_lines_.front().line != line) return std::nullopt;
    const std::uint64_t dropped_bytes = truncated_lines_.front().dropped_bytes;
    truncated_lines_.pop_front();
    return dropped_bytes;
}

}  // namespace gsim::lexer
