#pragma once

#include <cstddef>
#include <string_view>

#include "lexer/number_reader.h"
#include "lexer/text_rules.h"

namespace gsim::lexer {

inline constexpr std::size_t kMaxWords = 500;

/// Reader of the words of a block, which it adds to the block. `text` is the token as in the source; the
/// result is kBad on an error, kEob if the block is past its limit.
class WordReader {
  public:
    /// Makes a reader; all arguments must outlive it.
    WordReader(BlockText& block, BlockErrors& errors, const TextCursor& cursor, NumberReader& numbers,
               const TextRules& rules)
        : block_(block), errors_(errors), cursor_(cursor), numbers_(numbers), rules_(rules) {}

    /// Starts the next block.
    void start_block() { saw_dwell_ = false; }

    /// Reads `X5`.
    Token word(std::string_view text, Value& value);
    /// Reads `AR=5` or `I1=5`.
    Token named_word(Address address, std::string_view text, Value& value);
    /// Reads `,C5`.
    Token comma_word(std::string_view text, Value& value);
    /// Reads a letter before an expression.
    Token letter(char c, Value& value);
    /// Reads `,C` before an expression.
    Token comma_letter(std::string_view text, Value& value);
    /// Reads any other address before an expression.
    Token open_word(Address address, Value& value);
    /// Reads CIP.
    Token intermediate_point(Value& value);

    /// Returns the index of the last word that was opened by a letter with an expression as its value.
    std::size_t open_word_index() const { return open_word_; }
    /// Returns true once a G04 has been read in this block; for better messages.
    bool saw_dwell() const { return saw_dwell_; }

  private:
    Token word_token(const Word& word) const;
    Token add(const Word& word, Value& value);

    BlockText& block_;
    BlockErrors& errors_;
    const TextCursor& cursor_;
    NumberReader& numbers_;
    const TextRules& rules_;
    std::size_t open_word_ = 0;
    bool saw_dwell_ = false;
};

}  // namespace gsim::lexer
