#pragma once

#include <array>
#include <random>
#include <string>
#include <string_view>

namespace gsim::codegen {

using Random = std::mt19937;

inline unsigned below(Random& random, unsigned bound) {
    return static_cast<unsigned>(random() % bound);
}

template <std::size_t size>
std::string one_of(Random& random, const std::array<std::string_view, size>& choices) {
    return std::string(choices[below(random, size)]);
}

}  // namespace gsim::codegen
