#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::codegen {

/// Blocks of a post for the actions of a path. A name of the post may have placeholders, which match a part
/// of an action's name and return in the block: "digital_output P{number} on" = "M64 P{number}". The name of
/// a placeholder defines its text. {digit} is one digit, {two_digits} two, {axis} a capital letter, {text}
/// anything that a comment may hold, all others are a number. A name that ends in _mm is a length, which is
/// written in the program's unit. A name without placeholders has priority, else the first in alphabetical
/// order is used.
class ActionBlocks {
  public:
    using Blocks = std::map<std::string, std::string, std::less<>>;

    explicit ActionBlocks(const Blocks& blocks);

    /// Returns the block for an action; it may be empty if the controller acts by itself. Returns no value if
    /// the post has no word. `unit_mm`: mm of the program's unit.
    std::optional<std::string> find_block(std::string_view action, double unit_mm) const;

  private:
    struct Pattern {
        std::vector<std::string> texts;         // around and between the placeholders
        std::vector<std::string> placeholders;  // one fewer
        std::string block;
    };

    static std::optional<std::vector<std::string>> match(const Pattern& pattern, std::string_view action);

    const Blocks& exact_;
    std::vector<Pattern> patterns_;
};

/// Action that brings the machine to a standstill, which any controller does with a dwell of zero time.
inline constexpr std::string_view kStandstillAction = "rest";
/// End of a text that is no block of its own: it is written in the block of the next motion.
inline constexpr std::string_view kNextBlockSuffix = " ...";

/// Returns the names of the placeholders in a text, in their order.
std::vector<std::string> placeholder_names(std::string_view text);

}  // namespace gsim::codegen
