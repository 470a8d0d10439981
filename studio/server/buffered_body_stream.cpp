#include "studio/server/buffered_body_stream.h"

#include <algorithm>
#include <array>

namespace gsim::studio {

namespace {

constexpr std::size_t kDiscardBufferSize = std::size_t{16} << 10U;

}  // namespace

ssize_t BufferedBodyStream::read(char* bytes, std::size_t size) {
    const ssize_t bytes_read = stream_.read(bytes, size);
    remaining_ =
        bytes_read > 0 ? remaining_ - std::min(remaining_, static_cast<std::uint64_t>(bytes_read)) : 0;
    return bytes_read;
}

ssize_t BufferedBodyStream::write(const char* bytes, std::size_t size) {
    std::array<char, kDiscardBufferSize> sink_buffer{};
    while (remaining_ > 0) read(sink_buffer.data(), std::min<std::uint64_t>(remaining_, sink_buffer.size()));
    return stream_.write(bytes, size);
}

}  // namespace gsim::studio
