#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gsim::script {

/// What would be right in place of a key that a word does not take, as the end of a sentence: "; write x".
/// `value`: what the script gives it, where that is a number; `taken`: the keys that the word takes.
std::string word_advice(std::string_view key, std::optional<double> value,
                        std::span<const std::string_view> taken);

}  // namespace gsim::script
