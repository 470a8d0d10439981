#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace gsim::accuracy {

/// Returns the actions of an operator during a recorded run (TIME:BYTE in s with ';' between) as a file of
/// overrides (gsim-run --overrides); empty: no action. Bytes are grbl's real-time commands: feed overrides in
/// steps of 10 % and 1 % within 10 to 200 %, rapid overrides of 25, 50 and 100 %. The error names any other
/// byte, such as a feed hold, because its end depends on when the standstill was detected.
Result<std::string> overrides_of(std::string_view inputs);

}  // namespace gsim::accuracy
