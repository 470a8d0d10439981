#include "runtime/simulation/text_stream.h"

#include <cerrno>

namespace gsim::simulation {

tl::expected<void, int> TextStream::flush() {
    write();
    if (!failed() && std::fflush(file_) != 0) error_ = errno;
    if (failed()) return tl::unexpected(*error_);
    return {};
}

void TextStream::write() {
    if (!failed() && std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) error_ = errno;
    buffer_.clear();
}

}  // namespace gsim::simulation
