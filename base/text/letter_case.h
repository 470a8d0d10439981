#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// Upper case, of ASCII letters alone and whatever the locale.
std::string upper(std::string_view text);
/// Lower case, likewise.
std::string lower(std::string_view text);

}  // namespace gsim::text
