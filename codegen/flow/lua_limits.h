#pragma once

#include <cstdint>

namespace gsim::codegen {

/// Max instructions that a jump in Lua may span: Lua supports 2^24.
inline constexpr std::uint64_t kMaxJumpWeight = 16'000'000;

}  // namespace gsim::codegen
