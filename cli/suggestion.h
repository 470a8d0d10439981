#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gsim::apps {

/// "; did you mean '--machine'?" for a word that is not known, or nothing where none of the known ones is
/// near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace gsim::apps
