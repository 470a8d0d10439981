#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gsim::codegen {

/// 64-bit checksum of a text that arrives in parts, to distinguish an edited script from a generated one. Not
/// for security. A multiply-and-fold hash over words of eight bytes.
class TextHash {
  public:
    void update(std::string_view part);
    std::uint64_t value() const;

  private:
    void mix(std::uint64_t word);

    std::uint64_t state_ = 0x9E3779B97F4A7C15U;
    std::uint64_t bytes_ = 0;
    std::uint64_t partial_ = 0;
    unsigned partial_bytes_ = 0;
};

/// Returns the hash in the form of the first line of a script: sixteen hexadecimal digits.
std::string to_hex(std::uint64_t hash);

}  // namespace gsim::codegen
