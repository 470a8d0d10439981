#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

#include "lexer/alias.h"
#include "lexer/block_text.h"
#include "lexer/diagnostics.h"
#include "lexer/source.h"
#include "lexer/style.h"
#include "lexer/token.h"

namespace gsim::lexer {

/// Limits of one block, far above those of a controller, so that no input makes the parser run out of memory.
inline constexpr std::size_t kMaxWords = 500;
inline constexpr std::size_t kMaxTokens = 2000;
inline constexpr int kMaxBrackets = 100;
inline constexpr std::size_t kMaxNumberBytes = 24;

/// Scanner of one source: passes tokens to the parser, words and comments to the block's arena.
class Lexer {
  public:
    /// Makes a lexer; all arguments must outlive it. `keep_raw`: BlockText::raw is filled.
    Lexer(Source& source, Diagnostics& diagnostics, const Aliases& aliases, Style style = Style::ab9,
          bool keep_raw = false);
    ~Lexer();
    Lexer(const Lexer&) = delete;
    Lexer& operator=(const Lexer&) = delete;

    /// Returns the next token. After kEob, kTape and kEnd the block is complete.
    Token next(Value& value);
    /// Returns the block being read.
    BlockText& block() { return block_; }
    /// Starts the next block, because the parser is done with this one.
    void start_block();
    /// Reports an error in the block, the first one only, and marks the block as bad.
    void fail(std::uint32_t column, DiagnosticKind kind, std::string_view message,
              std::string_view hint = {});
    /// Treats the first lines of the source as remarks. To be called before the first token.
    void skip_leader(std::uint32_t lines) { leader_lines_ = lines; }
    /// Returns the line that is read.
    std::uint32_t line() const { return line_; }
    bool in_leader() const { return line_ <= leader_lines_; }
    /// Ends the main program (RS274/NGC: M2 or M30); the text after it is read only from the next O-word on.
    void end_main_program() { ended_ = true; }
    void resume() { ended_ = false; }
    bool ended() const { return ended_; }
    /// Returns true before the first token of a block.
    bool at_block_start() const { return tokens_ == 0; }
    bool dropping() const { return dropping_; }
    bool is_ngc() const { return style_ == Style::rs274ngc; }
    /// Returns the column of the last token of next().
    std::uint32_t token_column() const { return token_column_; }
    Token last_token() const { return last_; }
    /// Returns the token before the last one.
    Token previous_token() const { return previous_; }
    std::uint32_t previous_column() const { return previous_column_; }
    /// Returns the index of the last word that was opened by a letter with an expression as its value.
    std::size_t open_word_index() const { return open_word_; }
    /// Returns true once a G04 has been read in this block; for better messages.
    bool saw_dwell() const { return saw_dwell_; }

    // Actions of the generated scanner, one for each of its rules; `text` is the token as in the source.
    std::size_t fill(char* buffer, std::size_t capacity);
    void advance(const char* text, std::size_t size);
    void unread(std::size_t kept);
    Token word(std::string_view text, Value& value);
    Token comma_word(std::string_view text, Value& value);
    Token comma_letter(std::string_view text, Value& value);
    Token flow_name(std::string_view text, Value& value);
    Token flow_expression();
    Token named_variable(std::string_view text, Value& value);
    Token unterminated_name();
    Token power(Value& value);
    Token print_text(std::string_view text, Value& value);
    Token print_switch(std::string_view name, Value& value);
    Token named_word(Address address, std::string_view text, Value& value);
    Token letter(char c, Value& value);
    Token open_word(Address address, Value& value);
    Token identifier(std::string_view text, std::size_t& kept, Value& value);
    /// Sets `kept` to the length of the name if the next one is joined to it, because blanks have no meaning
    /// in RS274/NGC.
    Token expression_name(std::string_view text, std::size_t& kept, Value& value);
    Token sequence(std::string_view text, Value& value);
    Token skip(std::string_view text, Value& value);
    Token program(std::string_view text, Value& value);
    Token variable(std::string_view text, Value& value);
    Token number(std::string_view text, Value& value);
    Token symbol(char c, Value& value);
    Token tape(Value& value);
    bool open_bracket();
    bool close_bracket();  ///< Returns true if the expression is over.
    void start_assignment() { expression_to_end_ = true; }
    bool in_expression() const { return expression_to_end_ || brackets_ > 0; }
    void comment_part(std::string_view text);
    bool begins_block(std::string_view text) const;  ///< True for a keyword or an alias, after ';'.
    void remark_part(std::string_view text);
    Token unknown(std::string_view text);
    void nested_comment();
    void end_of_dos_file() { dos_file_ended_ = true; }
    Token newline();
    Token semicolon();
    Token end_of_file();

  private:
    Token classify(const Word& word) const;
    Token add_word(const Word& word, Value& value);
    Slice add_name(std::string_view text);
    Slice strip_leading_zeros(Slice name) const;
    std::optional<Slice> add_number(std::string_view digits, bool negative);
    Token fail_name(std::string_view text);

    struct CutLine {
        std::uint32_t line;
        std::uint64_t dropped_bytes;
    };

    Source& source_;
    Diagnostics& diagnostics_;
    const Aliases& aliases_;
    Style style_;
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
    std::uint32_t previous_column_ = 1;
    std::size_t open_word_ = 0;
    std::size_t tokens_ = 0;
    int brackets_ = 0;
    bool expression_to_end_ = false;  ///< The remainder of the block is expressions: after '=' or an O-word.
    int tape_marks_ = 0;
    bool ended_ = false;
    bool saw_dwell_ = false;
    bool dos_file_ended_ = false;  ///< By the byte 0x1A.
    std::uint32_t leader_lines_ = 0;
    bool dropping_ = false;  ///< The block is past a limit: the remainder of its line is ignored.

    // Line guard of fill().
    std::uint32_t read_line_ = 1;
    std::size_t read_line_bytes_ = 0;
    std::deque<CutLine> cut_lines_;
};

}  // namespace gsim::lexer
