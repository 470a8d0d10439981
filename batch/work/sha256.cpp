#include "batch/work/sha256.h"

#include <array>
#include <stdexcept>

#include <openssl/evp.h>

namespace gsim::batch {

std::string sha256(std::string_view bytes) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned count = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &count, EVP_sha256(), nullptr) != 1)
        throw std::runtime_error("this system's OpenSSL has no SHA-256");
    std::string text;
    for (unsigned i = 0; i < count; ++i) {
        text += kDigits[digest[i] >> 4U];
        text += kDigits[digest[i] & 15U];
    }
    return text;
}

}  // namespace gsim::batch
