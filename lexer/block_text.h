#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lexer/diagnostics.h"

namespace gsim::lexer {

/// Address before a value: the upper-case ASCII letter, or one of the longer addresses below.
using Address = std::uint8_t;
inline constexpr Address kArcAngle = 128;  ///< AR=, angle of an arc in degrees.
inline constexpr Address kViaX = 129;      ///< I1=, J1=, K1=: the via point of CIP.
inline constexpr Address kViaY = 130;
inline constexpr Address kViaZ = 131;
inline constexpr Address kIntermediatePoint = 132;  ///< CIP itself, a word without a value.
inline constexpr Address kChamfer = 133;            ///< ,C: chamfer between this move and the next.
inline constexpr Address kCornerRadius = 134;       ///< ,R: rounding between this move and the next.
inline constexpr Address kLineAngle = 135;          ///< ,A: direction of a line.
inline constexpr Address kPolarRadius = '@';        ///< RS274/NGC
inline constexpr Address kPolarAngle = '^';
inline constexpr Address kSpindle = '$';

/// Returns the address as in a message: "X", "AR=", "I1=", ...
std::string address_name(Address address);
/// Returns true for letters that are only an axis; X and U may also be the seconds of a dwell.
constexpr bool is_axis_letter(Address address) {
    return (address >= 'A' && address <= 'C') || (address >= 'V' && address <= 'Z' && address != 'X') ||
           address == kPolarRadius || address == kPolarAngle;
}

/// Meaning that the grammar finds for a word with an ambiguous letter.
enum class Role : std::uint8_t {
    plain,      ///< The letter is unambiguous (or the code that reads it is).
    axis,       ///< X or U as an axis.
    time,       ///< X, U or P as the seconds of a dwell.
    program,    ///< P as the program that M98 calls, or the block that M99 returns to.
    parameter,  ///< P as a parameter of another code.
};

/// Part of BlockText::text.
struct Slice {
    std::uint32_t begin = 0;
    std::uint32_t size = 0;
};

/// Word of a block: an address and its value, which is a number as written or an expression.
struct Word {
    Address address = 0;
    Role role = Role::plain;
    std::uint32_t column = 0;
    Slice number;                  ///< Sign and digits, without blanks and '+'; empty for an expression.
    std::int32_t expression = -1;  ///< Index of the expression's root in the syntax tree.
    std::int32_t code_x10 = -1;    ///< For a G or M word: 921 for G92.1, 40 for M04; -1: not a code's number.
};

enum class BlockEnd : std::uint8_t { line, semicolon, file };

/// Scanner's data of the block that it reads: the arena that parser values index.
struct BlockText {
    Location begin;  ///< Start of the line; its column is 1.
    std::vector<Word> words;
    std::vector<Slice> numbers;  ///< Numbers of expressions, loops and jumps.
    std::vector<Slice> comments;
    Slice program;     ///< Name that follows O; without blanks and in lower case if it was in < >.
    Slice print;       ///< Text of DPRNT, between its brackets.
    std::string text;  ///< Numbers, names and comments, in order.
    std::string raw;   ///< The block as in the source; kept on request only.
    BlockEnd end = BlockEnd::line;
    bool has_line_comment = false;  ///< The last comment follows ';', not between ( and ).
    bool structural = false;        ///< It has a word of a control structure, understood or not.
    bool bad = false;               ///< An error has been reported for this block.

    std::string_view view(Slice slice) const {
        return std::string_view(text).substr(slice.begin, slice.size);
    }
    Slice add(std::string_view fragment);
    /// Starts a comment, to which its parts are added.
    void start_comment() { comments.push_back({static_cast<std::uint32_t>(text.size()), 0}); }
    void add_to_comment(std::string_view fragment) { comments.back().size += add(fragment).size; }
    /// Adds a part of the remark that ';' begins, which is the last comment.
    void add_to_line_comment(std::string_view fragment) {
        if (!has_line_comment) start_comment();
        has_line_comment = true;
        add_to_comment(fragment);
    }
    Location at(std::uint32_t column) const { return {begin.line_begin, begin.line, column}; }
    void clear();
};

}  // namespace gsim::lexer
