#include "base/toml/toml_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "base/text/utf8.h"

namespace gsim::base {

namespace {

constexpr std::string_view kWhitespace = " \t";
constexpr std::string_view kPlainEnd = ",]}#\r\n";
constexpr std::string_view kBareKeyEnd = " \t.=]\r\n#\"'";

/// Meaning of a letter that follows a backslash, except for the codes.
struct Escape {
    char letter;
    char meaning;
};
constexpr std::array kEscapes{Escape{'b', '\b'}, Escape{'t', '\t'}, Escape{'n', '\n'}, Escape{'f', '\f'},
                              Escape{'r', '\r'}, Escape{'"', '"'},  Escape{'\\', '\\'}};

/// Returns the unescaped text between quotation marks on one line.
std::optional<std::string> unescaped(std::string_view quoted) {
    std::string text;
    for (std::size_t i = 0; i < quoted.size(); ++i) {
        if (quoted[i] != '\\') {
            text += quoted[i];
            continue;
        }
        if (++i == quoted.size()) return std::nullopt;
        const auto* const plain = std::find_if(kEscapes.begin(), kEscapes.end(),
                                               [&](const Escape& each) { return each.letter == quoted[i]; });
        if (plain != kEscapes.end()) {
            text += plain->meaning;
            continue;
        }
        const std::size_t digits = quoted[i] == 'u' ? 4 : quoted[i] == 'U' ? 8 : 0;
        if (digits == 0 || i + digits >= quoted.size()) return std::nullopt;
        std::uint32_t code = 0;
        const char* const first = quoted.data() + i + 1;
        if (std::from_chars(first, first + digits, code, 16).ptr != first + digits) return std::nullopt;
        text += text::utf8(code);
        i += digits;
    }
    return text;
}

}  // namespace

bool TomlScanner::consume(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
}

void TomlScanner::skip_blanks() {
    at_ = std::min(text_.find_first_not_of(kWhitespace, at_), text_.size());
}

void TomlScanner::skip_line() {
    const std::size_t end = text_.find('\n', at_);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
}

void TomlScanner::skip_blanks_and_lines() {
    while (true) {
        skip_blanks();
        if (!at_end() && (at_line_end() || peek() == '#')) {
            skip_line();
        } else {
            return;
        }
    }
}

std::optional<std::string> TomlScanner::read_key_part() {
    if (peek() == '"' || peek() == '\'') {
        const bool literal = peek() == '\'';
        const std::size_t begin = at_ + 1;
        if (!skip_string()) return std::nullopt;
        const std::string_view quoted = text_.substr(begin, at_ - 1 - begin);
        return literal ? std::string(quoted) : unescaped(quoted);
    }
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(kBareKeyEnd, at_), text_.size());
    if (at_ == begin) return std::nullopt;
    return std::string(text_.substr(begin, at_ - begin));
}

std::optional<TomlPath> TomlScanner::read_key() {
    TomlPath key;
    do {
        skip_blanks();
        auto part = read_key_part();
        if (!part) return std::nullopt;
        key.emplace_back(*std::move(part));
        skip_blanks();
    } while (consume('.'));
    return key;
}

std::optional<TomlItem> TomlScanner::read_pair() {
    TomlItem item;
    item.begin = at_;
    auto key = read_key();
    if (!key) return std::nullopt;
    item.key = *std::move(key);
    item.key_end = text_.find_last_not_of(kWhitespace, at_ - 1) + 1;
    if (!consume('=')) return std::nullopt;
    skip_blanks();
    auto value = read_value();
    if (!value) return std::nullopt;
    item.value = *std::move(value);
    item.end = item.value.bytes.end;
    return item;
}

bool TomlScanner::skip_string() {
    const char quote = peek();
    const std::string delimiter(3, quote);
    const bool is_multiline = text_.substr(at_).starts_with(delimiter);
    skip(is_multiline ? delimiter.size() : 1);
    while (!at_end()) {
        if (is_multiline ? text_.substr(at_).starts_with(delimiter) : peek() == quote) break;
        if (!is_multiline && peek() == '\n') return false;
        skip(quote == '"' && peek() == '\\' ? 2 : 1);
    }
    if (at_end()) return false;
    skip(is_multiline ? delimiter.size() : 1);
    // Up to two quotation marks before the closing delimiter belong to the string.
    for (int more = 0; is_multiline && more < 2 && peek() == quote; ++more) skip(1);
    return true;
}

std::optional<TomlValueSpan> TomlScanner::read_value() {
    TomlValueSpan value_span;
    value_span.bytes.begin = at_;
    bool is_complete = true;
    switch (peek()) {
        case '"':
        case '\'': is_complete = skip_string(); break;
        case '[':
            value_span.kind = TomlValueSpan::Kind::array;
            is_complete = read_items(value_span, ']');
            break;
        case '{':
            value_span.kind = TomlValueSpan::Kind::table;
            is_complete = read_items(value_span, '}');
            break;
        default:
            at_ = std::min(text_.find_first_of(kPlainEnd, at_), text_.size());
            at_ = std::max(value_span.bytes.begin, text_.find_last_not_of(kWhitespace, at_ - 1) + 1);
            is_complete = at_ > value_span.bytes.begin;
    }
    if (!is_complete) return std::nullopt;
    value_span.bytes.end = at_;
    return value_span;
}

bool TomlScanner::read_items(TomlValueSpan& value_span, char close) {
    skip(1);
    while (true) {
        skip_blanks_and_lines();
        if (consume(close)) return true;
        std::optional<TomlItem> item;
        if (close == '}') {
            item = read_pair();
        } else if (auto value = read_value()) {
            const TomlRange bytes = value->bytes;
            item = TomlItem{{}, bytes.begin, bytes.begin, *std::move(value), bytes.end};
        }
        if (!item) return false;
        skip_blanks_and_lines();
        if (consume(',')) {
            item->end = at_;
        } else if (peek() != close) {
            return false;
        }
        value_span.items.push_back(*std::move(item));
    }
}

}  // namespace gsim::base
