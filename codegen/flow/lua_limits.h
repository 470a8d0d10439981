#pragma once

#include <cstdint>

namespace gsim::codegen {

/// Over how many instructions a jump in Lua may lead at most: Lua can do 2^24.
inline constexpr std::uint64_t kMaxJumpWeight = 16'000'000;

}  // namespace gsim::codegen
