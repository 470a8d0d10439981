#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gsim::script {

/// Returns a suggested fix for a key that a word does not accept, as the end of a message: "; write x".
/// `value`: the script's value for it, if that is a number; `used_letters`: the keys that the word accepts.
std::string word_advice(std::string_view key, std::optional<double> value,
                        std::span<const std::string_view> used_letters);

}  // namespace gsim::script
