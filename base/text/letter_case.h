#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// Returns the text in upper case; changes only ASCII letters, whatever the locale.
std::string upper(std::string_view text);
/// Returns the text in lower case, likewise.
std::string lower(std::string_view text);

}  // namespace gsim::text
