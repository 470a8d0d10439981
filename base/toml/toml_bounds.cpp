#include "base/toml/toml_bounds.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace gsim::base {

namespace {

constexpr std::size_t kMaxTomlMiB = kMaxTomlBytes >> 20U;

/// Scanner of a TOML text up to the first position that is nested too deeply. If the text is not TOML, it may
/// misread what follows; the parser stops there.
class TomlScan {
  public:
    explicit TomlScan(std::string_view text) : text_(text) {}

    std::optional<Error> find() {
        while (at_ < text_.size()) {
            const std::size_t begin = at_;
            if (const auto message = step(); !message.empty()) return excess(begin, message);
        }
        return std::nullopt;
    }

  private:
    // Moves past one character, comment or string. Returns a message if that is nested too deeply.
    std::string step() {
        switch (const char c = text_[at_]) {
            case '#': at_ = std::min(text_.find('\n', at_), text_.size()); return {};
            case '"':
            case '\'': skip_string(c); return {};
            default: ++at_; return count(c);
        }
    }

    std::string count(char c) {
        switch (c) {
            case '.':
                if (++parts_ <= kMaxTomlKeyParts) return {};
                return fmt::format("more than {} names joined by dots", kMaxTomlKeyParts);
            case '[':
            case '{':
                parts_ = 1;
                if (++brackets_ <= kMaxTomlBrackets) return {};
                return fmt::format("arrays and tables are nested deeper than {}", kMaxTomlBrackets);
            case ']':
            case '}':
                parts_ = 1;
                if (brackets_ > 0) --brackets_;
                return {};
            case '=':
            case ',':
            case '\n': parts_ = 1; return {};
            default: return {};
        }
    }

    void skip_string(char quote) {
        const std::string delimiter(3, quote);
        const bool is_multiline = text_.substr(at_).starts_with(delimiter);
        at_ += is_multiline ? delimiter.size() : 1;
        while (at_ < text_.size()) {
            if (is_multiline ? text_.substr(at_).starts_with(delimiter) : text_[at_] == quote) break;
            if (!is_multiline && text_[at_] == '\n') return;  // no string: the parser stops here
            at_ += quote == '"' && text_[at_] == '\\' ? 2 : 1;
        }
        at_ += is_multiline ? delimiter.size() : 1;
        // Up to two quotes before the closing delimiter belong to the string.
        for (int more = 0; is_multiline && more < 2 && at_ < text_.size() && text_[at_] == quote; ++more)
            ++at_;
    }

    Error excess(std::size_t at, std::string message) const {
        const std::string_view before = text_.substr(0, at);
        const std::size_t line_begin = before.rfind('\n') + 1;  // 0 in the first line
        const std::string_view line_start = before.substr(line_begin);
        const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
        return {std::move(message),
                1 + static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n')),
                1 + static_cast<std::uint32_t>(
                        std::count_if(line_start.begin(), line_start.end(), starts_character))};
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t brackets_ = 0;
    std::size_t parts_ = 1;
};

}  // namespace

std::optional<Error> find_toml_bounds_error(std::string_view toml_text) {
    if (toml_text.size() > kMaxTomlBytes)
        return Error(fmt::format("files of up to {} MiB are read", kMaxTomlMiB), 1, 1);
    return TomlScan(toml_text).find();
}

}  // namespace gsim::base
