#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

#include "lexer/alias.h"
#include "lexer/block_text.h"
#include "lexer/diagnostics.h"
#include "lexer/source.h"
#include "lexer/token.h"

namespace gsim::lexer {

/// Bounds of one block, far above what a controller takes, so that no input makes the parser run out of
/// memory.
inline constexpr std::size_t kMaxWords = 500;
inline constexpr std::size_t kMaxTokens = 2000;
inline constexpr int kMaxBrackets = 100;
inline constexpr std::size_t kMaxNumberBytes = 24;

/// The scanner of one source: tokens to the parser, words and comments to the block's arena.
class Lexer {
  public:
    /// Everything outlives the lexer. `keep_raw`: BlockText::raw is filled.
    Lexer(Source& source, Diagnostics& diagnostics, const Aliases& aliases, bool keep_raw = false);
    ~Lexer();
    Lexer(const Lexer&) = delete;
    Lexer& operator=(const Lexer&) = delete;

    /// The next token. After kEob, kTape and kEnd the block is complete.
    Token next(Value& value);
    /// The block being read.
    BlockText& block() { return block_; }
    /// The parser is done with the block: the next one starts.
    void start_block();
    /// Reports an error in the block, the first one only, and marks the block as bad.
    void fail(std::uint32_t column, std::string_view message);
    bool dropping() const { return dropping_; }
    /// Column and length of the token that next() gave last.
    std::uint32_t token_column() const { return token_column_; }
    std::uint32_t token_size() const { return token_size_; }
    Token last_token() const { return last_; }
    /// The token before the last one.
    Token previous_token() const { return previous_; }
    /// Index of the word that was opened last, by a letter whose value is an expression.
    std::size_t open_word_index() const { return open_word_; }
    /// True once a G04 has been read in this block; for better messages.
    bool saw_dwell() const { return saw_dwell_; }

    // The actions of the generated scanner, one for each of its rules; `text` is the token as it stands.
    std::size_t fill(char* buffer, std::size_t capacity);
    void advance(const char* text, std::size_t size);
    void give_back(std::size_t kept);
    Token word(std::string_view text, Value& value);
    Token named_word(Address address, std::string_view text, Value& value);
    Token letter(char c, Value& value);
    Token open_word(Address address, Value& value);
    Token identifier(std::string_view text, std::size_t& kept, Value& value);
    Token expression_name(std::string_view text, Value& value);
    Token sequence(std::string_view text, Value& value);
    Token skip(std::string_view text, Value& value);
    Token program(std::string_view text, Value& value);
    Token variable(std::string_view text, Value& value);
    Token number(std::string_view text, Value& value);
    Token symbol(char c, Value& value);
    Token tape(Value& value);
    bool open_bracket();
    bool close_bracket();  ///< True where the expression is over.
    void start_assignment() { in_assignment_ = true; }
    bool in_expression() const { return in_assignment_ || brackets_ > 0; }
    void comment_part(std::string_view text);
    bool begins_block(std::string_view text) const;  ///< A keyword or an alias, behind ';'.
    void remark_part(std::string_view text);
    Token unknown(std::string_view text);
    Token newline();
    Token semicolon();
    Token end_of_file();

  private:
    Token classify(const Word& word) const;
    Token add_word(const Word& word, Value& value);
    std::optional<Slice> add_number(std::string_view digits, bool negative);

    struct CutLine {
        std::uint32_t line;
        std::uint64_t dropped_bytes;
    };

    Source& source_;
    Diagnostics& diagnostics_;
    const Aliases& aliases_;
    bool keep_raw_;
    void* scanner_ = nullptr;
    BlockText block_;

    std::uint32_t line_ = 1;
    std::uint64_t line_begin_ = 0;
    std::uint32_t next_column_ = 1;
    std::uint32_t token_column_ = 1;
    std::uint32_t token_size_ = 0;
    Token last_ = kEnd;
    Token previous_ = kEnd;
    std::size_t open_word_ = 0;
    std::size_t tokens_ = 0;
    int brackets_ = 0;
    bool in_assignment_ = false;
    bool saw_dwell_ = false;
    bool in_remark_ = false;
    bool dropping_ = false;  ///< The block is past a bound: the rest of its line is not looked at.

    // The line guard of fill().
    std::uint32_t read_line_ = 1;
    std::size_t read_line_bytes_ = 0;
    std::deque<CutLine> cut_lines_;
};

}  // namespace gsim::lexer
