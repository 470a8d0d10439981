#include "codegen/blocks/plain_lines.h"

#include "base/text/digits.h"
#include "base/text/letter_case.h"
#include "base/text/read_number.h"

namespace gsim::codegen {

namespace {

constexpr std::size_t kMaxInspectedBytes = std::size_t{256} << 10U;

bool is_capital(char c) {
    return c >= 'A' && c <= 'Z';
}

std::string strip_comments(std::string_view line) {
    std::string plain;
    bool in_comment = false;
    for (const char c : line) {
        if (!in_comment && c == ';') break;
        if (c == '(') in_comment = true;
        if (!in_comment) plain += c;
        if (c == ')') in_comment = false;
    }
    return text::upper(plain);
}

}  // namespace

PlainLines::PlainLines(lexer::Source& source) {
    source.rewind();
    bytes_.resize(std::min<std::uint64_t>(source.size(), kMaxInspectedBytes));
    std::size_t done = 0;
    while (done < bytes_.size()) {
        const std::size_t count = source.read(bytes_.data() + done, bytes_.size() - done);
        if (count == 0) break;
        done += count;
    }
    bytes_.resize(done);
    source.rewind();
}

bool PlainLines::next() {
    while (at_ < bytes_.size()) {
        const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
        line_ = strip_comments(std::string_view(bytes_).substr(at_, end - at_));
        at_ = end + 1;
        ++number_;
        if (line_.find_first_not_of(" \t\r") != std::string::npos) return true;
    }
    return false;
}

bool PlainWords::consume_number(std::size_t begin) {
    std::size_t end = begin;
    if (end < line_.size() && (line_[end] == '-' || line_[end] == '+')) ++end;
    std::size_t digits = 0;
    std::size_t point = std::string_view::npos;
    for (; end < line_.size(); ++end) {
        if (text::is_digit(line_[end])) {
            ++digits;
        } else if (line_[end] == '.' && point == std::string_view::npos) {
            point = end;
        } else {
            break;
        }
    }
    if (digits == 0) return false;
    word_.digits = line_.substr(begin, end - begin);
    const std::string_view number = word_.digits.substr(word_.digits.front() == '+' ? 1 : 0);
    if (text::read_number(number.data(), number.data() + number.size(), word_.value).ec != std::errc())
        return false;
    word_.decimals = point == std::string_view::npos ? 0 : static_cast<int>(end - point - 1);
    at_ = end;
    return true;
}

bool PlainWords::next() {
    while (at_ < line_.size()) {
        const char c = line_[at_];
        if (c == '<') {
            at_ = std::min(line_.find('>', at_), line_.size());
            continue;
        }
        ++at_;
        if (!is_capital(c)) continue;
        const bool in_name = at_ >= 2 && (is_capital(line_[at_ - 2]) || line_[at_ - 2] == '_');
        const std::size_t number = std::min(line_.find_first_not_of(" \t", at_), line_.size());
        if (in_name || !consume_number(number)) continue;
        word_.letter = c;
        return true;
    }
    return false;
}

}  // namespace gsim::codegen
