#include "lexer/lexer.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

#include "lexer/scanner.h"

namespace gsim::lexer {

namespace {

constexpr std::uint64_t kByteOrderMarkBytes = 3;

}  // namespace

Lexer::Lexer(Source& source, Diagnostics& diagnostics, const Aliases& aliases, Style style, bool keep_raw)
    : source_(source),
      diagnostics_(diagnostics),
      aliases_(aliases),
      style_(style),
      keep_raw_(keep_raw),
      scanner_(make_scanner(this)) {
    if (source_.line_at(0, kByteOrderMarkBytes) == "\xEF\xBB\xBF") {
        std::array<char, kByteOrderMarkBytes> mark;
        source_.read(mark.data(), mark.size());
        line_begin_ = kByteOrderMarkBytes;
    }
    start_block();
}

Lexer::~Lexer() {
    free_scanner(scanner_);
}

Token Lexer::next(Value& value) {
    value = {};
    previous_ = last_;
    previous_column_ = token_column_;
    if (is_ngc() && tape_marks_ == 2) return last_ = kEnd;  // text after the tape's end is not read
    last_ = scan_token(value, scanner_);
    if (dos_file_ended_ && last_ != kEob && last_ != kEnd)
        fail(token_column_, DiagnosticKind::syntax,
             "there is text behind the byte 0x1A, which ends a file of DOS");
    if (last_ != kEob && last_ != kEnd && ++tokens_ > kMaxTokens) {
        fail(token_column_, DiagnosticKind::too_large,
             fmt::format("the block has more than {} symbols", kMaxTokens));
        dropping_ = true;
        last_ = kEob;
    }
    value.column = token_column_;
    return last_;
}

void Lexer::start_block() {
    block_.clear();
    block_.begin = {line_begin_, line_, 1};
    tokens_ = 0;
    brackets_ = 0;
    expression_to_end_ = false;
    saw_dwell_ = false;
}

void Lexer::fail(std::uint32_t column, DiagnosticKind kind, std::string_view message, std::string_view hint) {
    // Errors after the first one of a block are mostly its consequence.
    if (!block_.bad) diagnostics_.error(block_.at(column), kind, message, hint);
    block_.bad = true;
}

// Lines are cut before they reach flex, because its buffer grows with the longest token. So a file without a
// line end, however long, needs the memory of one line. The cut is reported when the scanner reaches that
// line's end.
std::size_t Lexer::fill(char* buffer, std::size_t capacity) {
    while (const std::size_t count = source_.read(buffer, capacity)) {
        std::size_t out = 0;
        for (std::size_t in = 0; in < count;) {
            const auto* end = static_cast<const char*>(std::memchr(buffer + in, '\n', count - in));
            const std::size_t size =
                end == nullptr ? count - in : static_cast<std::size_t>(end - (buffer + in));
            const std::size_t space_left = kMaxLineBytes - std::min(kMaxLineBytes, read_line_bytes_);
            const std::size_t kept = std::min(size, space_left);
            if (out != in) std::memmove(buffer + out, buffer + in, kept);
            out += kept;
            read_line_bytes_ += size;
            if (kept < size) {
                if (cut_lines_.empty() || cut_lines_.back().line != read_line_)
                    cut_lines_.push_back({read_line_, 0});
                cut_lines_.back().dropped_bytes += size - kept;
            }
            in += size;
            if (end != nullptr) {
                buffer[out++] = '\n';
                ++in;
                ++read_line_;
                read_line_bytes_ = 0;
            }
        }
        if (out > 0) return out;
    }
    return 0;
}

void Lexer::advance(const char* text, std::size_t size) {
    token_column_ = next_column_;
    token_size_ = static_cast<std::uint32_t>(size);
    next_column_ += static_cast<std::uint32_t>(size);
    if (keep_raw_ && size > 0 && text[size - 1] != '\n') block_.raw.append(text, size);
}

void Lexer::unread(std::size_t kept) {
    const std::size_t returned_bytes = token_size_ - kept;
    next_column_ -= static_cast<std::uint32_t>(returned_bytes);
    token_size_ = static_cast<std::uint32_t>(kept);
    if (keep_raw_) block_.raw.resize(block_.raw.size() - returned_bytes);
}

Token Lexer::newline() {
    if (!cut_lines_.empty() && cut_lines_.front().line == line_) {
        fail(1, DiagnosticKind::too_large, fmt::format("the line has more than {} bytes", kMaxLineBytes));
        line_begin_ += cut_lines_.front().dropped_bytes;
        cut_lines_.pop_front();
    }
    if (in_expression() && brackets_ > 0)
        fail(token_column_, DiagnosticKind::syntax, "']' is missing at the end of the block");
    dropping_ = false;
    block_.end = BlockEnd::line;
    ++line_;
    line_begin_ += next_column_ - 1;
    next_column_ = 1;
    return kEob;
}

Token Lexer::semicolon() {
    if (brackets_ > 0) fail(token_column_, DiagnosticKind::syntax, "']' is missing before ';'");
    block_.end = BlockEnd::semicolon;
    return kEob;
}

Token Lexer::end_of_file() {
    if (next_column_ == 1 && tokens_ == 0) return kEnd;
    const Token token = newline();
    return token;
}

}  // namespace gsim::lexer
