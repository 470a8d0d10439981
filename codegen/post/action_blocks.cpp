#include "codegen/post/action_blocks.h"

#include <algorithm>

#include "base/text/read_number.h"
#include "codegen/post/gcode_numbers.h"
#include "codegen/post/post.h"

namespace gsim::codegen {

namespace {

constexpr int kLengthDecimals = 6;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Returns the max number of bytes at the front of a text that a placeholder may match.
std::size_t matching_length(std::string_view placeholder, std::string_view text) {
    const auto count = [text](auto is_part) {
        return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_part) - text.begin());
    };
    if (placeholder == "digit") return std::min<std::size_t>(count(is_digit), 1);
    if (placeholder == "two_digits") return count(is_digit) < 2 ? 0 : 2;
    if (placeholder == "axis") return text.empty() || text[0] < 'A' || text[0] > 'Z' ? 0 : 1;
    if (placeholder == "text") {
        return count([](char c) { return std::string_view("()%#;").find(c) == std::string_view::npos; });
    }
    return count([](char c) { return is_digit(c) || c == '.' || c == '-'; });
}

std::string in_unit(const std::string& number, double unit_mm) {
    return trimmed(text::parse_number(number).value_or(0) / unit_mm, kLengthDecimals);
}

}  // namespace

std::vector<std::string> placeholder_names(std::string_view text) {
    std::vector<std::string> placeholders;
    std::size_t close = 0;
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', close)) {
        close = text.find('}', open);
        if (close == std::string_view::npos) break;
        placeholders.emplace_back(text.substr(open + 1, close - open - 1));
    }
    return placeholders;
}

ActionBlocks::ActionBlocks(const Blocks& blocks) : exact_(blocks) {
    for (const auto& [name, block] : blocks) {
        Pattern pattern{{}, placeholder_names(name), block};
        if (pattern.placeholders.empty()) continue;
        std::string_view remainder = name;
        for (const std::string& placeholder : pattern.placeholders) {
            const std::size_t open = remainder.find('{');
            pattern.texts.emplace_back(remainder.substr(0, open));
            remainder.remove_prefix(open + placeholder.size() + 2);
        }
        pattern.texts.emplace_back(remainder);
        patterns_.push_back(std::move(pattern));
    }
}

// Each placeholder matches as much as it may, up to the text that follows it.
std::optional<std::vector<std::string>> ActionBlocks::match(const Pattern& pattern, std::string_view action) {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < pattern.placeholders.size(); ++i) {
        if (!action.starts_with(pattern.texts[i])) return std::nullopt;
        action.remove_prefix(pattern.texts[i].size());
        std::size_t size = matching_length(pattern.placeholders[i], action);
        if (!pattern.texts[i + 1].empty()) size = std::min(size, action.find(pattern.texts[i + 1]));
        if (size == 0) return std::nullopt;
        found.emplace_back(action.substr(0, size));
        action.remove_prefix(size);
    }
    if (action != pattern.texts.back()) return std::nullopt;
    return found;
}

std::optional<std::string> ActionBlocks::find_block(std::string_view action, double unit_mm) const {
    if (const auto found = exact_.find(action); found != exact_.end()) return found->second;
    for (const Pattern& pattern : patterns_) {
        const auto values = match(pattern, action);
        if (!values) continue;
        PlaceholderValues placeholders;
        for (std::size_t i = 0; i < values->size(); ++i) {
            const std::string& placeholder = pattern.placeholders[i];
            placeholders[placeholder] =
                placeholder.ends_with("_mm") ? in_unit((*values)[i], unit_mm) : (*values)[i];
        }
        return fill_template(pattern.block, placeholders);
    }
    return std::nullopt;
}

}  // namespace gsim::codegen
