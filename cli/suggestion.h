#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gsim::apps {

/// Returns "; did you mean '--machine'?" for an unknown word, or nothing if no known one is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace gsim::apps
