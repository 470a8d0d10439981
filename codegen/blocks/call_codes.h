#pragma once

#include <cstdint>

namespace gsim::codegen {

/// Codes of calls between programs, in the form of grammar::Code::code_x10.
inline constexpr std::int32_t kCallCode = 980;    // M98
inline constexpr std::int32_t kReturnCode = 990;  // M99
inline constexpr std::int32_t kMacroCode = 650;   // G65

}  // namespace gsim::codegen
