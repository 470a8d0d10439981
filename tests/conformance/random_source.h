#pragma once

#include <cstddef>
#include <initializer_list>
#include <random>
#include <string>
#include <string_view>

namespace gsim::conformance {

/// Choices and numbers from a seed, the same on every platform.
class RandomSource {
  public:
    explicit RandomSource(std::size_t seed) : bits_(static_cast<std::mt19937::result_type>(seed)) {}

    unsigned below(unsigned bound) { return static_cast<unsigned>(bits_() % bound); }
    int between(int min, int max) {
        return min + static_cast<int>(below(static_cast<unsigned>(max - min) + 1));
    }
    /// True `percent` times of a hundred.
    bool chance(unsigned percent) { return below(100) < percent; }
    std::string_view one_of(std::initializer_list<std::string_view> choices) {
        return choices.begin()[below(static_cast<unsigned>(choices.size()))];
    }

    /// Returns a decimal number with up to three digits after its point.
    std::string decimal(int min, int max);
    /// The same as a word of G-code: X12.5.
    std::string word(std::string_view letter, int min, int max) {
        return std::string(letter) + decimal(min, max);
    }

  private:
    std::mt19937 bits_;
};

}  // namespace gsim::conformance
