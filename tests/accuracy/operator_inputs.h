#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace gsim::accuracy {

/// What an operator did while a run was recorded, TIME:BYTE in s with ';' between, as a file of overrides
/// (gsim-run --overrides); empty: nothing. Bytes are grbl's real-time commands: feed overrides in steps of
/// 10 % and 1 % within 10 to 200 %, rapid ones of 25, 50 and 100 %. The error names a byte that is none of
/// these, as a feed hold, whose end depends on when it was seen to stand.
tl::expected<std::string, std::string> overrides_of(std::string_view inputs);

}  // namespace gsim::accuracy
