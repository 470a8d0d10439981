#include "codegen/lua/text_hash.h"

#include <bit>
#include <cstring>

#include <fmt/format.h>

namespace gsim::codegen {

void TextHash::mix(std::uint64_t word) {
    state_ = (state_ ^ word) * 0xD6E8FEB86659FD93U;
    state_ ^= state_ >> 32U;
}

void TextHash::update(std::string_view part) {
    bytes_ += part.size();
    std::size_t i = 0;
    while (i < part.size() && partial_bytes_ != 0) {
        partial_ |= static_cast<std::uint64_t>(static_cast<unsigned char>(part[i++]))
                    << (8U * partial_bytes_);
        partial_bytes_ = (partial_bytes_ + 1) % 8;
        if (partial_bytes_ == 0) {
            mix(partial_);
            partial_ = 0;
        }
    }
    static_assert(std::endian::native == std::endian::little, "the fast path reads little-endian words");
    for (; i + 8 <= part.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, part.data() + i, 8);
        mix(word);
    }
    for (; i < part.size(); ++i, ++partial_bytes_) {
        partial_ |= static_cast<std::uint64_t>(static_cast<unsigned char>(part[i])) << (8U * partial_bytes_);
    }
}

std::uint64_t TextHash::value() const {
    TextHash last = *this;
    last.mix(partial_);
    last.mix(bytes_);
    return last.state_;
}

std::string to_hex(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

}  // namespace gsim::codegen
