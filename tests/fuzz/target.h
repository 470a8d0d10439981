#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gsim::fuzz {

/// What became of an input.
struct Outcome {
    bool accepted = false;              ///< It is right, and was read to its end.
    std::optional<std::string> broken;  ///< A sentence about a promise that does not hold.
};

inline Outcome accepted() {
    return {.accepted = true, .broken = {}};
}
inline Outcome refused() {
    return {};
}
inline Outcome broken(std::string sentence) {
    return {.accepted = false, .broken = std::move(sentence)};
}

/// Something of the project that reads what others wrote.
struct Target {
    std::string_view name;
    /// Of the folder of its corpus (tests/fuzz/corpus) and of its dictionary: targets that read the same
    /// share them.
    std::string_view family;
    /// Reads any bytes whatever and looks at what must hold for all of them.
    Outcome (*check)(std::string_view input);
    /// Whether the system refuses files beyond those of the fuzzer. Not where what refuses them is ours, and
    /// is tried.
    bool confined = true;
};

/// All of them.
std::span<const Target> targets();
/// The target of that name; null where there is none.
const Target* find_target(std::string_view name);

}  // namespace gsim::fuzz
