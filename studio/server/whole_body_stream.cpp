#include "studio/server/whole_body_stream.h"

#include <algorithm>
#include <array>

namespace gsim::studio {

namespace {

constexpr std::size_t kThrownAway = std::size_t{16} << 10U;

}  // namespace

ssize_t WholeBodyStream::read(char* bytes, std::size_t size) {
    const ssize_t got = stream_.read(bytes, size);
    left_ = got > 0 ? left_ - std::min(left_, static_cast<std::uint64_t>(got)) : 0;
    return got;
}

ssize_t WholeBodyStream::write(const char* bytes, std::size_t size) {
    std::array<char, kThrownAway> rest{};
    while (left_ > 0) read(rest.data(), std::min<std::uint64_t>(left_, rest.size()));
    return stream_.write(bytes, size);
}

}  // namespace gsim::studio
