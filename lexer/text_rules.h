#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lexer/names.h"

namespace gsim::lexer {

/// Forms of program texts.
enum class TextForm : std::uint8_t {
    blocks,  ///< Blocks of words, for the scanner and the grammar.
    /// One command per line with its parameters by name (Klipper): read without the scanner.
    command_lines,
};

/// Rules by which the text of a dialect's programs is read. Each member names one property; without it the
/// text is ISO code with macro statements (#1=.., IF [..] GOTO, WHILE [..] DO) and aliases.
struct TextRules {
    TextForm form = TextForm::blocks;
    std::string_view controller = {};  ///< Name in messages, as in "no operator of the 9/Series".

    /// Blanks have no meaning, not even within numbers and names, so letters never join to names: `G 1 0` is
    /// G10, and macro keywords and aliases do not exist. ';' begins a remark, not another block.
    bool blanks_within_words = false;
    bool has_o_words = false;                 ///< O-words: `o100 sub`, `o1 if [..]`.
    bool names_in_angle_brackets = false;     ///< Names of parameters and programs in < >.
    bool has_power_operator = false;          ///< `**`
    bool chained_comparisons = false;         ///< Comparisons bind from left to right: 1 LT 2 EQ 1.
    bool separate_assignments = false;        ///< An assignment may not share its block with words.
    bool unbracketed_variable_index = false;  ///< `#-[3]` and `#ATAN[1]/[1]` need no brackets.
    /// X, U and P mean what the other words of their block make of them: an axis, a dwell time, a program.
    bool ambiguous_words = false;
    bool brackets_in_comments = false;    ///< A comment may contain '('.
    bool tape_marks_end_program = false;  ///< Text past the second % is not read.
    bool tape_leader = false;             ///< Lines before the first % are the leader of a tape.
    /// Hint for a block that begins like a macro statement, if the dialect has none; empty: it has them.
    std::string_view missing_keywords_hint = {};

    std::span<const ExpressionName> expression_names = {};  ///< Functions and operators of expressions.
};

}  // namespace gsim::lexer
