#include "codegen/post/program_text.h"

#include "base/text/format.h"

namespace gsim::codegen {

namespace {

constexpr std::size_t kEnough = std::size_t{1} << 16;
constexpr std::uint64_t kMaxNumber = 99'999;

bool is_numbered(std::string_view line) {
    return line.empty() || std::string_view("%Oo(").find(line[0]) == std::string_view::npos;
}

}  // namespace

std::string comment_text(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        if (c == '(' || c == ')' || c == ';') continue;
        const auto byte = static_cast<unsigned char>(c);
        out += byte >= 0x20 && byte < 0x7f ? c : '?';
    }
    return out;
}

void ProgramText::begin() {
    ++begun_;
    first_word_ = true;
    if (post_.blocks.number_step == 0) return;
    number_ += static_cast<std::uint64_t>(post_.blocks.number_step);
    if (number_ > kMaxNumber) number_ = static_cast<std::uint64_t>(post_.blocks.number_step);
    text_.push_back('N');
    const fmt::format_int digits(number_);
    for (auto digit_count = static_cast<int>(digits.size()); digit_count < post_.blocks.number_digits;
         ++digit_count) {
        text_.push_back('0');
    }
    text_.append(digits.data(), digits.data() + digits.size());
    first_word_ = false;
}

void ProgramText::end() {
    text_.push_back('\n');
    if (text_.size() >= kEnough) flush();
}

void ProgramText::flush() {
    sink_({text_.data(), text_.size()});
    text_.clear();
}

void ProgramText::code(std::string_view text) {
    if (!first_word_) text_.push_back(' ');
    first_word_ = false;
    text_.append(text.data(), text.data() + text.size());
}

void ProgramText::word(std::string_view letter, std::int64_t increments, const DecimalFormat& format) {
    code(letter);
    format.append(text_, increments);
}

void ProgramText::lines(const std::vector<std::string>& templates) {
    for (const std::string& each : templates) {
        const std::string line = fill_template(each, placeholders_);
        if (is_numbered(line))
            begin();
        else
            begin_unnumbered();
        code(line);
        end();
    }
}

void ProgramText::block(std::string_view line, const PlaceholderValues& values) {
    begin();
    code(fill_template(line, values));
    end();
}

void ProgramText::comment(std::string_view text) {
    text::append_format(text_, "({})", comment_text(text));
    end();
}

}  // namespace gsim::codegen
