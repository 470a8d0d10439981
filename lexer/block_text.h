#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lexer/diagnostics.h"

namespace gsim::lexer {

/// What stands before a value: the upper-case ASCII letter, or one of the longer addresses below.
using Address = std::uint8_t;
inline constexpr Address kArcAngle = 128;  ///< AR=, angle of an arc in degrees.
inline constexpr Address kViaX = 129;      ///< I1=, J1=, K1=: the point that CIP goes through.
inline constexpr Address kViaY = 130;
inline constexpr Address kViaZ = 131;
inline constexpr Address kIntermediatePoint = 132;  ///< CIP itself, a word without a value.
inline constexpr Address kChamfer = 133;            ///< ,C: chamfer between this move and the next.
inline constexpr Address kCornerRadius = 134;       ///< ,R: rounding between this move and the next.
inline constexpr Address kLineAngle = 135;          ///< ,A: direction of a line.
inline constexpr Address kPolarRadius = '@';        ///< RS274/NGC
inline constexpr Address kPolarAngle = '^';
inline constexpr Address kSpindle = '$';

/// "X", "AR=", "I1=", ...: the address as a message writes it.
std::string address_name(Address address);
/// True for letters that are an axis and nothing else; X and U may also be the seconds of a dwell.
constexpr bool is_axis_letter(Address address) {
    return (address >= 'A' && address <= 'C') || (address >= 'V' && address <= 'Z' && address != 'X') ||
           address == kPolarRadius || address == kPolarAngle;
}

/// The meaning that the grammar finds for a word whose letter has several.
enum class Role : std::uint8_t {
    plain,      ///< The letter says it all (or the code that takes it does).
    axis,       ///< X or U as an axis.
    time,       ///< X, U or P as the seconds of a dwell.
    program,    ///< P as the program that M98 calls, or the block that M99 returns to.
    parameter,  ///< P as a parameter of another code.
};

/// A stretch of BlockText::text.
struct Slice {
    std::uint32_t begin = 0;
    std::uint32_t size = 0;
};

/// One word of a block: an address and its value, which is a number as written or an expression.
struct Word {
    Address address = 0;
    Role role = Role::plain;
    std::uint32_t column = 0;
    Slice number;  ///< Sign and digits, without blanks and '+'; empty where an expression stands.
    std::int32_t expression = -1;  ///< Index of the expression's root in the syntax tree.
    std::int32_t code_x10 = -1;    ///< Of a G or M word: 921 for G92.1, 40 for M04; -1: not a code's number.
};

enum class BlockEnd : std::uint8_t { line, semicolon, file };

/// What the scanner knows of the block that it reads: the arena that parser values index.
struct BlockText {
    Location begin;  ///< Of the line; its column is 1.
    std::vector<Word> words;
    std::vector<Slice> numbers;  ///< Of expressions, loops and jumps.
    std::vector<Slice> comments;
    Slice program;     ///< Name behind O; without blanks and in lower case where it stood in < >.
    Slice print;       ///< What DPRNT writes, between its brackets.
    std::string text;  ///< Numbers, names and comments, one after the other.
    std::string raw;   ///< The block as it stands in the source; kept on request only.
    BlockEnd end = BlockEnd::line;
    bool remark = false;      ///< The last comment stands behind ';', not between ( and ).
    bool structural = false;  ///< A word of a control structure stands in it, understood or not.
    bool bad = false;         ///< An error has been reported for this block.

    std::string_view view(Slice slice) const {
        return std::string_view(text).substr(slice.begin, slice.size);
    }
    Slice add(std::string_view piece);
    Location at(std::uint32_t column) const { return {begin.line_begin, begin.line, column}; }
    void clear();
};

}  // namespace gsim::lexer
