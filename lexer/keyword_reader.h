#pragma once

#include <cstddef>
#include <string_view>

#include "lexer/alias.h"
#include "lexer/name_reader.h"
#include "lexer/word_reader.h"

namespace gsim::lexer {

/// Reader of the words with several letters: keywords of macro statements, names of the machine data, DPRNT.
/// `text` is the token as in the source; the result is kBad on an error.
class KeywordReader {
  public:
    /// Makes a reader; all arguments must outlive it.
    KeywordReader(BlockText& block, BlockErrors& errors, const TextCursor& cursor, WordReader& words,
                  NameReader& names, const Aliases& aliases)
        : block_(block), errors_(errors), cursor_(cursor), words_(words), names_(names), aliases_(aliases) {}

    /// Reads a keyword, an alias or a program. Sets `kept` to the length of a keyword before digits, which
    /// are the next token.
    Token identifier(std::string_view text, std::size_t& kept, Value& value);
    /// Reads `DPRNT[..]`.
    Token print_text(std::string_view text, Value& value);
    /// Returns true if the text that follows ';' begins a block: with a keyword or an alias.
    bool begins_block(std::string_view text) const;

  private:
    Token reject(std::string_view text, std::string_view name);

    BlockText& block_;
    BlockErrors& errors_;
    const TextCursor& cursor_;
    WordReader& words_;
    NameReader& names_;
    const Aliases& aliases_;
};

}  // namespace gsim::lexer
