#include "runtime/simulation/text_stream.h"

#include <cerrno>
#include <system_error>

namespace gsim::simulation {

tl::expected<void, std::string> TextStream::flush() {
    write();
    if (!failed() && std::fflush(file_) != 0) fail();
    if (failed()) return tl::unexpected(*error_);
    return {};
}

void TextStream::write() {
    if (!failed() && std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) fail();
    buffer_.clear();
}

void TextStream::fail() {
    error_ = "cannot write: " + std::generic_category().message(errno);
}

}  // namespace gsim::simulation
