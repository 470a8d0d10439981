#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lexer/alias.h"
#include "lexer/block_errors.h"
#include "lexer/block_text.h"
#include "lexer/diagnostics.h"
#include "lexer/expression_nesting.h"
#include "lexer/keyword_reader.h"
#include "lexer/line_guard.h"
#include "lexer/name_reader.h"
#include "lexer/number_reader.h"
#include "lexer/program_extent.h"
#include "lexer/source.h"
#include "lexer/text_cursor.h"
#include "lexer/text_rules.h"
#include "lexer/token.h"
#include "lexer/word_reader.h"

namespace gsim::lexer {

// Limits of one block, far above those of a controller, so that no input makes the parser run out of memory:
// this one, kMaxWords, kMaxBrackets and kMaxNumberBytes.
inline constexpr std::size_t kMaxTokens = 2000;

/// Scanner of one source: passes tokens to the parser, words and comments to the block's arena.
class Lexer {
  public:
    /// Makes a lexer; all arguments must outlive it. `keep_raw`: BlockText::raw is filled.
    Lexer(Source& source, Diagnostics& diagnostics, const Aliases& aliases, const TextRules& rules,
          bool keep_raw = false);
    ~Lexer();
    Lexer(const Lexer&) = delete;
    Lexer& operator=(const Lexer&) = delete;

    /// Returns the next token. At kEob, kTape and kEnd the block is complete.
    Token next(Value& value);
    /// Starts the next block, because the parser is done with this one.
    void start_block();
    /// Returns the block being read.
    BlockText& block() { return block_; }
    /// Returns the errors of that block.
    BlockErrors& errors() { return errors_; }
    /// Returns the parts of the source that are not read.
    ProgramExtent& extent() { return extent_; }
    const TextRules& rules() const { return rules_; }
    /// Returns the position of the last token of next().
    const TextCursor& cursor() const { return cursor_; }
    Token last_token() const { return last_; }
    /// Returns the token before the last one.
    Token previous_token() const { return previous_; }
    std::uint32_t previous_column() const { return previous_column_; }

    // Readers of tokens, for the rules of the generated scanner.
    LineGuard& lines() { return lines_; }
    ExpressionNesting& nesting() { return nesting_; }
    NumberReader& numbers() { return numbers_; }
    WordReader& words() { return words_; }
    const WordReader& words() const { return words_; }
    NameReader& names() { return names_; }
    KeywordReader& keywords() { return keywords_; }

    // Actions of the generated scanner.
    /// Returns true before the first token of a block.
    bool is_at_block_start() const { return tokens_ == 0; }
    /// Passes over a token, as in the source.
    void advance(const char* text, std::size_t size) {
        cursor_.advance(size);
        if (keep_raw_ && size > 0 && text[size - 1] != '\n') block_.raw.append(text, size);
    }
    /// Returns to the first `kept` bytes of the last token.
    void unread(std::size_t kept);
    /// Reads an operator or a bracket.
    Token symbol(char c, Value& value);
    /// Reads `%`.
    Token tape();
    Token newline();
    Token semicolon();
    Token end_of_file();

  private:
    const TextRules& rules_;
    bool keep_raw_;
    void* scanner_ = nullptr;
    BlockText block_;
    BlockErrors errors_;
    TextCursor cursor_;
    LineGuard lines_;
    ProgramExtent extent_;
    ExpressionNesting nesting_;
    NumberReader numbers_;
    WordReader words_;
    NameReader names_;
    KeywordReader keywords_;
    Token last_ = kEnd;
    Token previous_ = kEnd;
    std::uint32_t previous_column_ = 1;
    std::size_t tokens_ = 0;
};

}  // namespace gsim::lexer
