#include "studio/engine/message.h"

#include <bit>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace gsim::studio {

// Columns are read without a copy, here and in a page on a computer that is little-endian as well.
static_assert(std::endian::native == std::endian::little);

namespace {

constexpr std::size_t kAlignment = 8;

void pad(std::string& bytes) {
    bytes.resize((bytes.size() + kAlignment - 1) / kAlignment * kAlignment, '\0');
}

void write_number(std::string& bytes, std::size_t at, std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data() + at, &number, sizeof number);
}

}  // namespace

std::string Message::bytes() const {
    const std::string header = header_.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string bytes(kAlignment, '\0');
    bytes += header;
    pad(bytes);
    for (const std::string& part : parts_) {
        bytes += part;
        pad(bytes);
    }
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
        throw std::length_error("a message of more than 4 GB");
    write_number(bytes, 0, bytes.size());
    write_number(bytes, sizeof(std::uint32_t), header.size());
    return bytes;
}

}  // namespace gsim::studio
