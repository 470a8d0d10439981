#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "grammar/dialect.h"
#include "lexer/lexer.h"

namespace gsim::lexer {

/// Result of the scanner for a text: its tokens, and the words of all blocks written as `X=5`.
struct Scan {
    std::vector<Token> tokens;
    std::vector<std::string> words;
    std::vector<std::string> comments;
    std::vector<std::string> programs;  ///< Names after O.
    std::vector<std::string> names;     ///< Names of named parameters.
    std::vector<std::string> printed;   ///< Texts of DPRNT.
    std::vector<Value> values;          ///< One for each token.
    std::string messages;               ///< "line:column: text" of the errors, one a line.
};

/// As the writer does it, a block with M2 or M30 ends the main program if the dialect has it so.
inline Scan scan(std::string_view text, const Aliases& aliases = {},
                 const grammar::Dialect& dialect = grammar::dialect_ab9()) {
    Scan result;
    Source source = Source::from_text(std::string(text), "t");
    Diagnostics diagnostics(source, 1000, [&](const text::Diagnostic& reported) {
        const std::string message = text::to_text(reported);
        const std::string_view line = std::string_view(message).substr(0, message.find('\n'));
        result.messages += std::string(line.substr(2)) + "\n";  // without "t:"
    });
    Lexer lexer(source, diagnostics, aliases, dialect.text());
    while (true) {
        Value value{};
        const Token token = lexer.next(value);
        if (token == kEnd) return result;
        result.tokens.push_back(token);
        result.values.push_back(value);
        const BlockText& block = lexer.block();
        if (token == kProgram || token == kFlowName) result.programs.emplace_back(block.view(block.program));
        if (token == kNamedVariable) result.names.emplace_back(block.view(block.numbers[value.index]));
        if (token == kPrint) result.printed.emplace_back(block.view(block.print));
        if (token != kEob && token != kTape) continue;
        for (const Word& word : block.words) {
            const bool ends = word.address == 'M' && (word.code_x10 == 20 || word.code_x10 == 300);
            if (ends && dialect.rules().end_code_ends_text) lexer.extent().end_main_program();
            result.words.push_back(fmt::format("{}={}", address_name(word.address), block.view(word.number)));
        }
        for (const Slice comment : block.comments) result.comments.emplace_back(block.view(comment));
        lexer.start_block();
    }
}

inline Scan scan_ngc(std::string_view text) {
    return scan(text, {}, grammar::dialect_rs274ngc());
}

}  // namespace gsim::lexer
