#include "base/text/base64.h"

namespace gsim::text {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kGroup = 3;

/// Up to three bytes as four digits; those that no byte stands behind are '='.
void put_group(std::string_view bytes, std::string& text) {
    unsigned value = 0;
    for (std::size_t i = 0; i < kGroup; ++i)
        value = value << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    for (std::size_t i = 0; i <= kGroup; ++i) {
        const unsigned digit = value >> (18U - 6U * i) & 63U;
        text.push_back(i <= bytes.size() ? kDigits[digit] : '=');
    }
}

}  // namespace

void Base64::add(std::string_view bytes, std::string& text) {
    while (!rest_.empty() && rest_.size() < kGroup && !bytes.empty()) {
        rest_.push_back(bytes.front());
        bytes.remove_prefix(1);
    }
    if (rest_.size() == kGroup) {
        put_group(rest_, text);
        rest_.clear();
    }
    for (; bytes.size() >= kGroup; bytes.remove_prefix(kGroup)) put_group(bytes.substr(0, kGroup), text);
    rest_ += bytes;
}

void Base64::end(std::string& text) {
    if (!rest_.empty()) put_group(rest_, text);
    rest_.clear();
}

}  // namespace gsim::text
