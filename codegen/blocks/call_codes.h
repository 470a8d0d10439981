#pragma once

#include <cstdint>

namespace gsim::codegen {

/// The codes by which programs call each other, as grammar::Code::code_x10 has them.
inline constexpr std::int32_t kCallCode = 980;    // M98
inline constexpr std::int32_t kReturnCode = 990;  // M99
inline constexpr std::int32_t kMacroCode = 650;   // G65

}  // namespace gsim::codegen
