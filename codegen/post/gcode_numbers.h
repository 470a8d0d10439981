#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "codegen/post/post.h"

namespace gsim::codegen {

/// Printed increments of a number that is not known.
inline constexpr std::int64_t kUnknownIncrements = INT64_MIN;

/// Decimals of numbers that are no positions.
inline constexpr int kValueDecimals = 6;

/// Format of numbers with so many decimals. The written value is an integer count of increments of the last
/// decimal, so two values are the same word if their increments are equal.
class DecimalFormat {
  public:
    DecimalFormat(int decimals, TrailingZeros zeros) : decimals_(decimals), trailing_zeros_(zeros) {
        for (int i = 0; i < decimals; ++i) decimal_scale_ *= 10;
    }

    std::int64_t increments(double value) const {
        return std::llround(value * static_cast<double>(decimal_scale_));
    }
    double value(std::int64_t increments) const {
        return static_cast<double>(increments) / static_cast<double>(decimal_scale_);
    }
    void append(fmt::memory_buffer& out, std::int64_t increments) const;

  private:
    int decimals_;
    TrailingZeros trailing_zeros_;
    std::int64_t decimal_scale_ = 1;
};

/// Returns a number with at most so many decimals, without zeros at the end.
inline std::string trimmed(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') == std::string::npos) return text;
    text.resize(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

inline void DecimalFormat::append(fmt::memory_buffer& out, std::int64_t increments) const {
    if (increments < 0) {
        out.push_back('-');
        increments = -increments;
    }
    const fmt::format_int integer_part(increments / decimal_scale_);
    out.append(integer_part.data(), integer_part.data() + integer_part.size());
    std::int64_t fraction = increments % decimal_scale_;
    char digits[20];
    for (int i = decimals_; i > 0; fraction /= 10) digits[--i] = static_cast<char>('0' + fraction % 10);
    int digit_count = decimals_;
    if (trailing_zeros_ != TrailingZeros::keep) {
        while (digit_count > 0 && digits[digit_count - 1] == '0') --digit_count;
    }
    if (digit_count > 0 || trailing_zeros_ == TrailingZeros::point) out.push_back('.');
    out.append(digits, digits + digit_count);
}

}  // namespace gsim::codegen
