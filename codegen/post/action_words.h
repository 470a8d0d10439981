#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::codegen {

/// The blocks of a post for the actions of a path. A name of the post may hold places, which stand for a part
/// of an action's name and come back in the block: "digital_output P{number} on" = "M64 P{number}". What a
/// place takes is said by its name: {digit} one digit, {two_digits} two, {axis} a capital letter, {text}
/// anything that a comment may hold, all others a number; one whose name ends in _mm is a length, which is
/// written in the program's unit. A name without places goes before all others, else the first in
/// alphabetical order is taken.
class ActionWords {
  public:
    using Blocks = std::map<std::string, std::string, std::less<>>;

    explicit ActionWords(const Blocks& blocks);

    /// The block for an action, which may be empty: the control does so by itself. None where the post has no
    /// word. `unit_mm`: mm of the program's unit.
    std::optional<std::string> block_of(std::string_view action, double unit_mm) const;

  private:
    struct Pattern {
        std::vector<std::string> texts;   // before, between and behind the places
        std::vector<std::string> places;  // one fewer
        std::string block;
    };

    static std::optional<std::vector<std::string>> match(const Pattern& pattern, std::string_view action);

    const Blocks& exact_;
    std::vector<Pattern> patterns_;
};

/// The action that has the machine come to rest, which any control does by a dwell of no time.
inline constexpr std::string_view kRest = "rest";
/// What a block ends in that is no block of its own: it stands in that of the next motion.
inline constexpr std::string_view kInNextBlock = " ...";

/// The names of the places in a text, in their order.
std::vector<std::string> places_in(std::string_view text);

}  // namespace gsim::codegen
