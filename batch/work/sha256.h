#pragma once

#include <string>
#include <string_view>

namespace gsim::batch {

/// Returns the SHA-256 hash (FIPS 180-4) of bytes, in hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace gsim::batch
