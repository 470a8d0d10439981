#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "grammar/code.h"
#include "lexer/text_rules.h"

namespace gsim::grammar {

/// Meaning of a letter, or of a longer address.
struct Letter {
    std::string_view address;
    std::string_view meaning;
};

/// Command with a name instead of a letter and a number. Its parameters are NAME=VALUE.
struct ExtendedCommand {
    std::string_view name;
    std::string_view parameters;  ///< Those that are numbers, between blanks,
    std::string_view texts;       ///< and those that are texts.
    std::string_view meaning;
};

/// Rules for the words of one block.
struct BlockRules {
    std::string_view standalone = {};   ///< Letters that are words by themselves, if no code accepts them.
    std::string_view move_words = {};   ///< Letters that a modal motion accepts in addition to axis words.
    std::string_view dwell_words = {};  ///< Letters for the time of G4, of which it needs one.
    /// All values of a block are read before its settings and codes act; else each assignment acts at once.
    bool values_before_actions = false;
    bool computed_codes = false;  ///< The number of a G or M code may be an expression.
    /// A code with axis words as its data may share a block with a motion only if no axis word is in it; else
    /// the code has the words and the motion becomes modal.
    bool data_excludes_motion = false;
    bool shared_words = false;          ///< A word belongs to each code of its block that accepts it.
    bool separate_calls = false;        ///< M98 may not share its block with other codes.
    std::span<const Phase> order = {};  ///< Execution order; phases that are not listed come last.
};

/// Description of a dialect: its properties and the rows of its tables. A derived dialect changes a copy of
/// the description of its base (Dialect), so it inherits all that it does not set.
struct DialectRules {
    std::string_view name;        ///< As --dialect has it.
    std::string_view title;       ///< As people call it.
    std::string_view lua_module;  ///< Module that its scripts require.
    lexer::TextRules text = {};   ///< Dialect sets its names of expressions.
    BlockRules blocks = {};
    std::string_view initial = {};  ///< Codes in force when a program begins, between blanks.

    bool always_mm = false;             ///< Lengths without G20 or G21 are always mm.
    bool has_block_jumps = false;       ///< GOTO, and M99 P, which continues at a block.
    bool active_comments = false;       ///< A comment may act: (MSG,text).
    bool first_program_counts = false;  ///< Of several programs with one number the first is called.
    bool end_code_ends_text = false;    ///< Text past M2 and M30 is read only from the next O-word on.
    bool offset_variables = false;      ///< Work offsets are stored in variables, too.

    std::vector<Code> codes = {};
    std::vector<Letter> letters = {};
    std::vector<lexer::ExpressionName> expression_names = {};
    std::vector<ExtendedCommand> extended = {};
};

}  // namespace gsim::grammar
