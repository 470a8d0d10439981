#include "codegen/blocks/active_comment.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "base/text/letter_case.h"
#include "codegen/lua/lua_text.h"
#include "codegen/lua/word_writer.h"

namespace gsim::codegen {

namespace {

enum class ArgumentKind : unsigned char { none, text, values };

struct ActiveComment {
    std::string_view name;
    ArgumentKind argument;
    bool needs_comma;
};

constexpr std::array kActiveComments = {
    ActiveComment{"MSG", ArgumentKind::text, true},
    ActiveComment{"DEBUG", ArgumentKind::values, true},
    ActiveComment{"PRINT", ArgumentKind::values, true},
    ActiveComment{"LOGOPEN", ArgumentKind::text, true},
    ActiveComment{"LOGAPPEND", ArgumentKind::text, true},
    ActiveComment{"LOGCLOSE", ArgumentKind::none, false},
    ActiveComment{"LOG", ArgumentKind::values, true},
    ActiveComment{"PROBEOPEN", ArgumentKind::text, false},
    ActiveComment{"PROBECLOSE", ArgumentKind::none, false},
    ActiveComment{"ABORT", ArgumentKind::values, true},
    ActiveComment{"PYRUN", ArgumentKind::text, true},
    ActiveComment{"PYRELOAD", ArgumentKind::none, false},
    ActiveComment{"PY", ArgumentKind::text, true},
};

constexpr std::size_t kMaxValues = 50;  // a call of Lua accepts some 200 at most

/// Splits a text with values into a format for Lua's string.format and the values that follow it.
class FormattedValues {
  public:
    explicit FormattedValues(std::string_view text) : remaining_(text) {
        while (!remaining_.empty()) {
            if (remaining_[0] == '#' && consume_value()) continue;
            if (remaining_[0] == '%' && consume_format()) continue;
            add_plain(remaining_[0]);
            remaining_.remove_prefix(1);
        }
    }
    const std::string& format() const { return format_; }
    const std::string& values() const { return values_; }
    std::size_t count() const { return count_; }

  private:
    void add_plain(char c) {
        format_ += c;
        if (c == '%') format_ += c;
    }

    bool consume_value() {
        if (remaining_.size() > 1 && remaining_[1] == '<') {
            const std::size_t end = remaining_.find('>');
            if (end == std::string_view::npos) return false;
            std::string name;
            for (const char c : text::lower(remaining_.substr(2, end - 2))) {
                if (c != ' ' && c != '\t') name += c;
            }
            values_ += ", parameter(";
            write_lua_string(name, values_);
            values_ += ')';
            remaining_.remove_prefix(end + 1);
        } else {
            std::size_t end = 1;
            while (end < remaining_.size() && text::is_digit(remaining_[end])) ++end;
            if (end == 1) return false;
            values_ += parameter_argument(remaining_.substr(1, end - 1));
            remaining_.remove_prefix(end);
        }
        format_ += value_format_;
        ++count_;
        return true;
    }

    /// Returns the parameter with this number. A number that no parameter has is shown as one without a
    /// value. Comments may read the position during cutter compensation, but expressions may not read #5420
    /// to #5428.
    static std::string parameter_argument(std::string_view digits) {
        const std::string number = normalized_number(digits);
        const int value = number.size() <= kMaxDigits ? std::stoi(number) : 0;
        if (value >= kFirstPosition && value < kFirstPosition + static_cast<int>(kPositionNames.size()))
            return fmt::format(", parameter(\"_{}\")",
                               kPositionNames[static_cast<std::size_t>(value - kFirstPosition)]);
        return value >= 1 && value <= kLastParameter ? fmt::format(", v[{}]", value) : ", parameter(\"\")";
    }

    /// Reads %d, %f and %.3f: the formats of the values that follow.
    bool consume_format() {
        if (remaining_.starts_with("%d")) return set_format("%.0f", 2);
        if (remaining_.starts_with("%f")) return set_format("%.4f", 2);
        if (remaining_.size() >= 4 && remaining_[1] == '.' && text::is_digit(remaining_[2]) &&
            remaining_[3] == 'f')
            return set_format(std::string(remaining_.substr(0, 4)), 4);
        return false;
    }

    bool set_format(std::string format, std::size_t size) {
        value_format_ = std::move(format);
        remaining_.remove_prefix(size);
        return true;
    }

    static constexpr int kLastParameter = 5601;
    static constexpr int kFirstPosition = 5420;
    static constexpr std::string_view kPositionNames = "xyzabcuvw";  // of #5420 on: #<_x> and so on
    static constexpr std::size_t kMaxDigits = 4;                     // of its number

    std::string_view remaining_;
    std::string format_;
    std::string values_;
    std::string value_format_ = "%f";
    std::size_t count_ = 0;
};

std::string_view trim_blanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    return text;
}

const ActiveComment* find_active_comment(std::string_view name) {
    for (const ActiveComment& active : kActiveComments) {
        if (name.starts_with(active.name)) return &active;
    }
    return nullptr;
}

}  // namespace

Result<void> write_active_comment(std::string_view comment, std::string& out) {
    comment = trim_blanks(comment);
    const ActiveComment* active = find_active_comment(text::upper(comment.substr(0, 12)));
    if (active == nullptr) return {};
    std::string_view text = comment.substr(active->name.size());
    if (active->needs_comma) {
        if (!text.starts_with(',')) return {};
        text.remove_prefix(1);
    } else {
        text = trim_blanks(text);
    }
    if (active->argument == ArgumentKind::none && !text.empty()) return {};
    out += active->name;
    out += '(';
    if (active->argument == ArgumentKind::values) {
        const FormattedValues parts(text);
        if (parts.count() > kMaxValues)
            return Unexpected(fmt::format("a comment can print at most {} values", kMaxValues));
        write_lua_string(parts.format(), out);
        out += parts.values();
    } else if (active->argument == ArgumentKind::text) {
        write_lua_string(text, out);
    }
    out += ") ";
    return {};
}

}  // namespace gsim::codegen
