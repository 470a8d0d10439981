#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gsim::fuzz {

/// Result of an input.
struct Outcome {
    bool accepted = false;              ///< It is right, and was read to its end.
    std::optional<std::string> broken;  ///< Message about a broken promise.
};

inline Outcome accepted() {
    return {.accepted = true, .broken = {}};
}
inline Outcome rejected() {
    return {};
}
inline Outcome broken(std::string message) {
    return {.accepted = false, .broken = std::move(message)};
}

/// Something of the project that reads what others wrote.
struct Target {
    std::string_view name;
    /// Name of the folder of its corpus (tests/fuzz/corpus) and of its dictionary: targets that read the same
    /// share them.
    std::string_view family;
    /// Reads any bytes and checks what must hold for all of them.
    Outcome (*check)(std::string_view input);
    /// True if the system blocks files beyond those of the fuzzer. False if the blocking code is ours, and is
    /// tried.
    bool confined = true;
};

/// All of them.
std::span<const Target> targets();
/// Returns the target of that name, or null if it does not exist.
const Target* find_target(std::string_view name);

}  // namespace gsim::fuzz
