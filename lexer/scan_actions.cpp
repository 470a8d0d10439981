// Actions of the rules of gcode.l on the tokens that they find.

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "base/text/letter_case.h"
#include "lexer/blanks.h"
#include "lexer/lexer.h"
#include "lexer/names.h"

namespace gsim::lexer {

namespace {

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string_view skip_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return text;
}

/// Sign and digits of `[blanks][sign][blanks]digits`.
struct SignedDigits {
    bool negative = false;
    std::string_view digits;
};

SignedDigits split_sign(std::string_view text) {
    text = skip_blanks(text);
    SignedDigits result;
    if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
        result.negative = text.front() == '-';
        text = skip_blanks(text.substr(1));
    }
    result.digits = text;
    return result;
}

/// Returns ten times the number of a code with at most four digits and one decimal, such as 921 for "92.1";
/// else -1.
std::int32_t code_x10(const SignedDigits& number) {
    if (number.negative) return -1;
    const std::size_t dot = number.digits.find('.');
    std::string_view integer_part = number.digits.substr(0, dot);
    std::string_view part = dot == std::string_view::npos ? "" : number.digits.substr(dot + 1);
    while (part.size() > 1 && part.back() == '0') part.remove_suffix(1);
    while (integer_part.size() > 1 && integer_part.front() == '0') integer_part.remove_prefix(1);
    if (integer_part.size() > 4 || part.size() > 1) return -1;
    std::int32_t code = 0;
    for (const char c : integer_part) code = code * 10 + (c - '0');
    return code * 10 + (part.empty() ? 0 : part[0] - '0');
}

std::optional<std::uint32_t> parse_small_number(std::string_view digits) {
    while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
    if (digits.size() > 9) return std::nullopt;
    std::uint32_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

bool is_name_character(char c) {
    return text::is_digit(c) || c == '_' || (upper(c) >= 'A' && upper(c) <= 'Z');
}

/// Returns true for the start of an expression, a variable or a value after a keyword.
bool is_value_start(char c) {
    return c == '[' || c == '#' || c == '=' || text::is_digit(c);
}

const Keyword* find_keyword(std::string_view name) {
    const auto* found_entry =
        std::find_if(kKeywords.begin(), kKeywords.end(), [&](const Keyword& k) { return k.name == name; });
    return found_entry == kKeywords.end() ? nullptr : found_entry;
}

}  // namespace

std::optional<Slice> Lexer::add_number(std::string_view digits, bool negative) {
    if (digits.size() > kMaxNumberBytes) {
        fail(token_column_, DiagnosticKind::number,
             fmt::format("the number has {} characters, at most {} are allowed", digits.size(),
                         kMaxNumberBytes));
        return std::nullopt;
    }
    if (!negative) return block_.add(digits);
    Slice slice = block_.add("-");
    slice.size += block_.add(digits).size;
    return slice;
}

// RS274/NGC needs no alternative readings: its G4 accepts P alone, and U is an axis.
Token Lexer::classify(const Word& word) const {
    if (is_axis_letter(word.address)) return kAxis;
    if (is_ngc()) return word.address == 'X' || word.address == 'U' ? kAxis : kOther;
    switch (word.address) {
        case 'U':
        case 'X': return kAxisOrTime;
        case 'P': return kP;
        case 'G': return word.code_x10 == 40 ? kDwell : kOther;
        case 'M': return word.code_x10 == 980 || word.code_x10 == 990 ? kCall : kOther;
        default: return kOther;
    }
}

Token Lexer::add_word(const Word& word, Value& value) {
    if (block_.words.size() == kMaxWords) {
        fail(token_column_, DiagnosticKind::too_large,
             fmt::format("the block has more than {} words", kMaxWords));
        dropping_ = true;
        return kEob;
    }
    value.index = static_cast<std::uint32_t>(block_.words.size());
    block_.words.push_back(word);
    const Token token = classify(word);
    saw_dwell_ |= token == kDwell;
    return token;
}

Token Lexer::word(std::string_view text, Value& value) {
    Word word;
    word.address = static_cast<Address>(upper(text[0]));
    word.column = token_column_;
    const bool has_gaps = is_ngc() && has_blanks(text);
    const std::string without_gaps = has_gaps ? remove_blanks(text) : std::string();
    const SignedDigits number = split_sign((has_gaps ? std::string_view(without_gaps) : text).substr(1));
    const std::optional<Slice> slice = add_number(number.digits, number.negative);
    if (!slice) return kBad;
    word.number = *slice;
    if (word.address == 'G' || word.address == 'M') word.code_x10 = code_x10(number);
    return add_word(word, value);
}

Token Lexer::named_word(Address address, std::string_view text, Value& value) {
    Word word;
    word.address = address;
    word.column = token_column_;
    const std::size_t mark = text.find('=');
    const std::size_t value_begin = mark == std::string_view::npos ? text.find_first_of("CcRrAa") : mark;
    const SignedDigits number = split_sign(text.substr(value_begin + 1));
    const std::optional<Slice> slice = add_number(number.digits, number.negative);
    if (!slice) return kBad;
    word.number = *slice;
    return add_word(word, value);
}

namespace {

Address comma_address(char letter) {
    switch (upper(letter)) {
        case 'C': return kChamfer;
        case 'R': return kCornerRadius;
        default: return kLineAngle;
    }
}

}  // namespace

Token Lexer::comma_word(std::string_view text, Value& value) {
    return named_word(comma_address(text[text.find_first_of("CcRrAa")]), text, value);
}

Token Lexer::comma_letter(std::string_view text, Value& value) {
    return open_word(comma_address(text.back()), value);
}

Token Lexer::open_word(Address address, Value& value) {
    Word word;
    word.address = address;
    word.column = token_column_;
    open_word_ = block_.words.size();
    switch (add_word(word, value)) {
        case kAxis: return kAxisLetter;
        case kAxisOrTime: return kAxisOrTimeLetter;
        case kP: return kPLetter;
        case kEob: return kEob;
        default: return kOtherLetter;
    }
}

Token Lexer::letter(char c, Value& value) {
    return open_word(static_cast<Address>(upper(c)), value);
}

Token Lexer::identifier(std::string_view text, std::size_t& kept, Value& value) {
    if (const Aliases::Word* alias = aliases_.find(text)) {
        return word(std::string(1, alias->letter) + alias->number, value);
    }
    const std::string name = text::upper(text);
    if (name == "CIP") {
        Word word;
        word.address = kIntermediatePoint;
        word.column = token_column_;
        return add_word(word, value);
    }
    if (name == "POPEN" || name == "PCLOS") return print_switch(name, value);
    if (name == "DPRNT") {
        fail(token_column_, DiagnosticKind::syntax,
             "DPRNT takes its text in brackets, as in DPRNT[X#100[53]]");
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
    if (name[0] == 'O') return program(text.substr(1), value);
    std::string nearest = aliases_.nearest(name);
    if (nearest.empty()) {
        std::array<std::string, kKeywords.size()> names;
        std::transform(kKeywords.begin(), kKeywords.end(), names.begin(),
                       [](const Keyword& k) { return std::string(k.name); });
        nearest = nearest_name(name, names);
    }
    fail(token_column_, DiagnosticKind::syntax,
         fmt::format("'{}' is neither a keyword nor an alias of the machine data{}", text.substr(0, 40),
                     nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
    return kBad;
}

Token Lexer::sequence(std::string_view text, Value& value) {
    const std::string digits = remove_blanks(text.substr(1));
    const std::optional<std::uint32_t> number =
        parse_small_number(std::string_view(digits).substr(0, digits.find('.')));
    if (!number) {
        fail(token_column_, DiagnosticKind::number, "the sequence number has more than 9 digits");
        return kBad;
    }
    value.index = *number;
    return kSequence;
}

Token Lexer::skip(std::string_view text, Value& value) {
    const std::string_view digits = skip_blanks(text.substr(1));
    const std::uint32_t level = digits.empty() ? 1 : parse_small_number(digits).value_or(10);
    if (level < 1 || level > 9) {
        fail(token_column_, DiagnosticKind::number,
             fmt::format("block delete is / or /1 to /9, not {}", text.substr(0, 20)));
        return kBad;
    }
    value.index = level;
    return kSkip;
}

Token Lexer::program(std::string_view text, Value&) {
    const std::string_view name = skip_blanks(text);
    if (name.size() > 32) {
        fail(token_column_, DiagnosticKind::too_large, "the program name has more than 32 characters");
        return kBad;
    }
    block_.program = block_.add(name);
    return kProgram;
}

Token Lexer::variable(std::string_view text, Value& value) {
    const std::string digits = remove_blanks(text.substr(1));
    const std::size_t dot = std::min(digits.find('.'), digits.size());
    if (dot == 0 || digits.find_first_not_of('0', dot + 1) != std::string::npos) {
        fail(token_column_, DiagnosticKind::number,
             fmt::format("the number of a variable is whole, not {}", digits.substr(0, 40)));
        return kBad;
    }
    const std::optional<std::uint32_t> number = parse_small_number(std::string_view(digits).substr(0, dot));
    if (!number) {
        fail(token_column_, DiagnosticKind::number, "the variable's number has more than 9 digits");
        return kBad;
    }
    value.index = *number;
    return kVariable;
}

Token Lexer::number(std::string_view text, Value& value) {
    const bool has_gaps = has_blanks(text);
    const std::optional<Slice> slice = add_number(has_gaps ? remove_blanks(text) : text, false);
    if (!slice) return kBad;
    value.index = static_cast<std::uint32_t>(block_.numbers.size());
    block_.numbers.push_back(*slice);
    return kNumber;
}

Token Lexer::symbol(char c, Value& value) {
    constexpr std::string_view kOperators = "+-*/";
    const std::size_t index = kOperators.find(c);
    if (index != std::string_view::npos) value.index = static_cast<std::uint32_t>(index);
    return c == '#' ? kHash : static_cast<Token>(c);
}

Token Lexer::tape(Value&) {
    if (tokens_ == 0) {
        ++tape_marks_;
        return kTape;
    }
    fail(token_column_, DiagnosticKind::syntax, "a tape mark % stands at the start of a line");
    return kBad;
}

bool Lexer::open_bracket() {
    if (++brackets_ <= kMaxBrackets) return true;
    fail(token_column_, DiagnosticKind::nesting,
         fmt::format("brackets are nested more than {} deep", kMaxBrackets));
    dropping_ = true;
    return false;
}

bool Lexer::close_bracket() {
    if (brackets_ > 0) --brackets_;
    return brackets_ == 0 && !expression_to_end_;
}

void Lexer::comment_part(std::string_view text) {
    if (text.empty()) {
        block_.comments.push_back({static_cast<std::uint32_t>(block_.text.size()), 0});
        return;
    }
    block_.comments.back().size += block_.add(text).size;
}

bool Lexer::begins_block(std::string_view text) const {
    const auto* end = std::find_if_not(text.begin(), text.end(), [](char c) { return is_name_character(c); });
    const std::string_view name(text.data(), static_cast<std::size_t>(end - text.begin()));
    if (aliases_.find(name) != nullptr) return true;
    const std::string letters = text::upper(name.substr(0, name.find_first_of("0123456789")));
    if (letters == "CIP") return true;
    if (letters == "DPRNT" || letters == "POPEN" || letters == "PCLOS") return true;
    const bool keyword = letters == "AR" || find_keyword(letters) != nullptr;
    return keyword && (letters.size() < name.size() || is_value_start(text.back()));
}

void Lexer::remark_part(std::string_view text) {
    if (!block_.remark) comment_part({});
    block_.remark = true;
    comment_part(text);
}

void Lexer::nested_comment() {
    fail(token_column_, DiagnosticKind::syntax, "a comment holds no other '('; LinuxCNC refuses it, too");
}

Token Lexer::unknown(std::string_view text) {
    const char c = text[0];
    const bool visible = c > ' ' && c < 0x7f;
    if (c == ')') {
        fail(token_column_, DiagnosticKind::syntax,
             "')' without '('; a comment ends at its first ')', also where it holds another '('");
        return kBad;
    }
    fail(token_column_, DiagnosticKind::character,
         visible ? fmt::format("unexpected character '{}'", c)
                 : fmt::format("unexpected byte 0x{:02X}", static_cast<unsigned char>(c)));
    return kBad;
}

}  // namespace gsim::lexer
