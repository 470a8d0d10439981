#include "lexer/keyword_reader.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "base/text/letter_case.h"
#include "lexer/names.h"

namespace gsim::lexer {

namespace {

bool is_name_character(char c) {
    return text::is_digit(c) || c == '_' || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Returns true for the start of an expression, a variable or the value of a keyword.
bool is_value_start(char c) {
    return c == '[' || c == '#' || c == '=' || text::is_digit(c);
}

const Keyword* find_keyword(std::string_view name) {
    const auto* keyword = std::find_if(kKeywords.begin(), kKeywords.end(),
                                       [&](const Keyword& one) { return one.name == name; });
    return keyword == kKeywords.end() ? nullptr : keyword;
}

}  // namespace

Token KeywordReader::identifier(std::string_view text, std::size_t& kept, Value& value) {
    if (const Aliases::Word* alias = aliases_.find(text))
        return words_.word(std::string(1, alias->letter) + alias->number, value);
    const std::string name = text::upper(text);
    if (name == "CIP") return words_.intermediate_point(value);
    if (name == "POPEN" || name == "PCLOS") {
        value.index = static_cast<std::uint32_t>(name == "POPEN" ? Print::open : Print::close);
        return kPrint;
    }
    if (name == "DPRNT") {
        errors_.fail(cursor_.column(), DiagnosticKind::syntax,
                     "DPRNT requires its text in brackets, as in DPRNT[X#100[53]]");
        return kBad;
    }
    // GOTO100, DO1, END1: the digits are a separate token.
    const auto letters =
        static_cast<std::size_t>(std::find_if(name.begin(), name.end(), text::is_digit) - name.begin());
    const bool digits_only =
        std::all_of(name.begin() + static_cast<std::ptrdiff_t>(letters), name.end(), text::is_digit);
    if (const Keyword* keyword = find_keyword(name.substr(0, letters)); keyword != nullptr && digits_only) {
        kept = letters;
        block_.structural |= keyword->token == kWhile || keyword->token == kEndLoop;
        return keyword->token;
    }
    if (name[0] == 'O') return names_.program(text.substr(1));
    return reject(text, name);
}

Token KeywordReader::reject(std::string_view text, std::string_view name) {
    std::string nearest = aliases_.nearest(name);
    if (nearest.empty()) {
        std::array<std::string, kKeywords.size()> names;
        std::transform(kKeywords.begin(), kKeywords.end(), names.begin(),
                       [](const Keyword& one) { return std::string(one.name); });
        nearest = nearest_name(name, names);
    }
    errors_.fail(
        cursor_.column(), DiagnosticKind::syntax,
        fmt::format("'{}' is neither a keyword nor an alias of the machine data{}", text.substr(0, 40),
                    nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
    return kBad;
}

Token KeywordReader::print_text(std::string_view text, Value& value) {
    constexpr std::size_t kMaxPrinted = 400;
    const std::size_t begin = text.find('[') + 1;
    if (text.rfind(']') - begin > kMaxPrinted) {
        errors_.fail(cursor_.column(), DiagnosticKind::too_large,
                     fmt::format("DPRNT accepts at most {} characters", kMaxPrinted));
        return kBad;
    }
    block_.print = block_.add(text.substr(begin, text.rfind(']') - begin));
    value.index = static_cast<std::uint32_t>(Print::text);
    return kPrint;
}

bool KeywordReader::begins_block(std::string_view text) const {
    const auto* end = std::find_if_not(text.begin(), text.end(), [](char c) { return is_name_character(c); });
    const std::string_view name(text.data(), static_cast<std::size_t>(end - text.begin()));
    if (aliases_.find(name) != nullptr) return true;
    const std::string letters = text::upper(name.substr(0, name.find_first_of("0123456789")));
    if (letters == "CIP") return true;
    if (letters == "DPRNT" || letters == "POPEN" || letters == "PCLOS") return true;
    const bool keyword = letters == "AR" || find_keyword(letters) != nullptr;
    return keyword && (letters.size() < name.size() || is_value_start(text.back()));
}

}  // namespace gsim::lexer
