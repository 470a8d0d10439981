#include "lexer/lexer.h"

#include <array>

#include <fmt/format.h>

#include "lexer/scanner.h"

namespace gsim::lexer {

namespace {

constexpr std::uint64_t kByteOrderMarkBytes = 3;

}  // namespace

Lexer::Lexer(Source& source, Diagnostics& diagnostics, const Aliases& aliases, const TextRules& rules,
             bool keep_raw)
    : rules_(rules),
      keep_raw_(keep_raw),
      scanner_(make_scanner(this)),
      errors_(block_, diagnostics),
      lines_(source),
      nesting_(errors_, cursor_),
      numbers_(block_, errors_, cursor_),
      words_(block_, errors_, cursor_, numbers_, rules),
      names_(block_, errors_, cursor_, nesting_, rules),
      keywords_(block_, errors_, cursor_, words_, names_, aliases) {
    if (source.line_at(0, kByteOrderMarkBytes) == "\xEF\xBB\xBF") {
        std::array<char, kByteOrderMarkBytes> mark;
        source.read(mark.data(), mark.size());
        cursor_.skip(kByteOrderMarkBytes);
    }
    start_block();
}

Lexer::~Lexer() {
    free_scanner(scanner_);
}

Token Lexer::next(Value& value) {
    value = {};
    previous_ = last_;
    previous_column_ = cursor_.column();
    if (rules_.tape_marks_end_program && extent_.has_tape_ended()) return last_ = kEnd;
    last_ = scan_token(value, scanner_);
    if (extent_.has_dos_file_ended() && last_ != kEob && last_ != kEnd)
        errors_.fail(cursor_.column(), DiagnosticKind::syntax,
                     "there is text after the byte 0x1A, which ends a DOS file");
    if (last_ != kEob && last_ != kEnd && ++tokens_ > kMaxTokens) {
        errors_.exceed(cursor_.column(), DiagnosticKind::too_large,
                       fmt::format("the block has more than {} symbols", kMaxTokens));
        last_ = kEob;
    }
    value.column = cursor_.column();
    return last_;
}

void Lexer::start_block() {
    block_.clear();
    block_.begin = {cursor_.line_begin(), cursor_.line(), 1};
    tokens_ = 0;
    nesting_.start_block();
    words_.start_block();
}

void Lexer::unread(std::size_t kept) {
    const std::size_t returned_bytes = cursor_.unread(kept);
    if (keep_raw_) block_.raw.erase(block_.raw.size() - returned_bytes);
}

Token Lexer::symbol(char c, Value& value) {
    constexpr std::string_view kOperators = "+-*/";
    const std::size_t index = kOperators.find(c);
    if (index != std::string_view::npos) value.index = static_cast<std::uint32_t>(index);
    return c == '#' ? kHash : static_cast<Token>(c);
}

Token Lexer::tape() {
    if (tokens_ == 0) {
        extent_.add_tape_mark();
        return kTape;
    }
    errors_.fail(cursor_.column(), DiagnosticKind::syntax, "a tape mark % must be at the start of a line");
    return kBad;
}

Token Lexer::newline() {
    const std::optional<std::uint64_t> cut_bytes = lines_.release_cut(cursor_.line());
    if (cut_bytes)
        errors_.fail(1, DiagnosticKind::too_large,
                     fmt::format("the line has more than {} bytes", kMaxLineBytes));
    if (nesting_.in_brackets())
        errors_.fail(cursor_.column(), DiagnosticKind::syntax, "']' is missing at the end of the block");
    errors_.end_line();
    block_.end = BlockEnd::line;
    cursor_.start_line(cut_bytes.value_or(0));
    return kEob;
}

Token Lexer::semicolon() {
    if (nesting_.in_brackets())
        errors_.fail(cursor_.column(), DiagnosticKind::syntax, "']' is missing before ';'");
    block_.end = BlockEnd::semicolon;
    return kEob;
}

Token Lexer::end_of_file() {
    return cursor_.is_at_line_start() && tokens_ == 0 ? kEnd : newline();
}

}  // namespace gsim::lexer
