#include "base/text/base64.h"

namespace gsim::text {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kGroupBytes = 3;

/// Writes up to three bytes as four digits; digits without a byte are '='.
void append_group(std::string_view bytes, std::string& text) {
    unsigned value = 0;
    for (std::size_t i = 0; i < kGroupBytes; ++i)
        value = value << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    for (std::size_t i = 0; i <= kGroupBytes; ++i) {
        const unsigned digit = value >> (18U - 6U * i) & 63U;
        text.push_back(i <= bytes.size() ? kDigits[digit] : '=');
    }
}

/// Reads three bytes from four digits, fewer if padding is at their end. Returns false if they are not such
/// digits.
bool decode_group(std::string_view digits, std::string& bytes) {
    const std::size_t padding = digits.ends_with("==") ? 2 : digits.ends_with('=') ? 1 : 0;
    unsigned value = 0;
    for (const char digit : digits.substr(0, digits.size() - padding)) {
        const std::size_t number = kDigits.find(digit);
        if (number == std::string_view::npos) return false;
        value = value << 6U | static_cast<unsigned>(number);
    }
    value <<= 6U * padding;
    for (std::size_t i = 0; i < kGroupBytes - padding; ++i)
        bytes.push_back(static_cast<char>(value >> (16U - 8U * i) & 0xffU));
    return (value & ((1U << (8U * padding)) - 1U)) == 0;
}

}  // namespace

void Base64::add(std::string_view bytes, std::string& text) {
    while (!remaining_.empty() && remaining_.size() < kGroupBytes && !bytes.empty()) {
        remaining_.push_back(bytes.front());
        bytes.remove_prefix(1);
    }
    if (remaining_.size() == kGroupBytes) {
        append_group(remaining_, text);
        remaining_.clear();
    }
    for (; bytes.size() >= kGroupBytes; bytes.remove_prefix(kGroupBytes))
        append_group(bytes.substr(0, kGroupBytes), text);
    remaining_ += bytes;
}

void Base64::end(std::string& text) {
    if (!remaining_.empty()) append_group(remaining_, text);
    remaining_.clear();
}

std::optional<std::string> decode_base64(std::string_view text) {
    constexpr std::size_t kGroupDigits = 4;
    if (text.size() % kGroupDigits != 0) return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / kGroupDigits * kGroupBytes);
    for (; !text.empty(); text.remove_prefix(kGroupDigits)) {
        const std::string_view group = text.substr(0, kGroupDigits);
        if (group.find('=') != std::string_view::npos && text.size() > kGroupDigits) return std::nullopt;
        if (!decode_group(group, bytes)) return std::nullopt;
    }
    return bytes;
}

}  // namespace gsim::text
