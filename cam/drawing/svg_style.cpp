#include "cam/drawing/svg_style.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/text/trimmed.h"

namespace gsim::drawing {

namespace {

constexpr std::string_view kWhitespace = " \t\r\n\f";
constexpr std::size_t kMaxListed = 5;
constexpr std::size_t kMaxSelectorLength = 60;
constexpr std::size_t kMaxRules = 1000;  // each is looked at for each element
constexpr int kClassSpecificity = 100;
constexpr int kIdSpecificity = 10'000;
constexpr std::array<std::string_view, 2> kProperties = {"display", "visibility"};

std::string_view trim_blanks(std::string_view text) {
    return text::trimmed(text, kWhitespace);
}

// Returns the part in front of a separator, and removes it from the text.
std::string_view consume_until(std::string_view& text, char separator) {
    const std::string_view part = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return part;
}

std::string strip_comments(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        const std::size_t open = text.find("/*");
        plain += text.substr(0, open);
        if (open == std::string_view::npos) break;
        const std::size_t close = text.find("*/", open + 2);
        if (close == std::string_view::npos) break;
        text.remove_prefix(close + 2);
    }
    return plain;
}

// Returns a value from declarations such as "fill: none; display: none"; the last one counts.
std::string_view declaration_value(std::string_view declarations, std::string_view name) {
    std::string_view found;
    while (!declarations.empty()) {
        std::string_view value = consume_until(declarations, ';');
        if (value.find(':') == std::string_view::npos) continue;
        if (trim_blanks(consume_until(value, ':')) != name) continue;
        found = trim_blanks(value.substr(0, value.find('!')));  // without !important
    }
    return found;
}

bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::string_view consume_name(std::string_view& text) {
    const auto* const end = std::find_if_not(text.begin(), text.end(), is_name);
    const std::string_view name = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(name.size());
    return name;
}

// Returns the position past the closing brace of the block that begins with a brace.
std::size_t block_end(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && --depth == 0) return i + 1;
    }
    return text.size();
}

}  // namespace

std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return name.starts_with("svg:") ? name.substr(4) : name;
}

bool SvgStyles::Rule::matches(const pugi::xml_node& node) const {
    if (!element.empty() && local_name(node) != element) return false;
    if (!id.empty() && id != node.attribute("id").value()) return false;
    return std::all_of(classes.begin(), classes.end(), [&node](const std::string& requested) {
        std::string_view names = node.attribute("class").value();
        while (!(names = trim_blanks(names)).empty()) {
            const std::string_view name = names.substr(0, names.find_first_of(kWhitespace));
            if (name == requested) return true;
            names.remove_prefix(name.size());
        }
        return false;
    });
}

void SvgStyles::add(std::string_view text) {
    const std::string plain = strip_comments(text);
    std::string_view remainder = plain;
    while (!remainder.empty()) {
        const std::size_t open = remainder.find_first_of("{;");
        if (open == std::string_view::npos) return;
        if (remainder[open] == ';') {  // @import and the like
            remainder.remove_prefix(open + 1);
            continue;
        }
        const std::size_t end = block_end(remainder, open);
        std::string_view block = remainder.substr(open + 1, end - open - 1);
        if (block.ends_with('}')) block.remove_suffix(1);
        add_rule(trim_blanks(remainder.substr(0, open)), block);
        remainder.remove_prefix(end);
    }
}

std::optional<SvgStyles::Rule> SvgStyles::parse_selector(std::string_view selector) {
    if (selector.empty()) return {};
    Rule rule;
    if (selector.starts_with('*')) {
        selector.remove_prefix(1);
    } else {
        rule.element = consume_name(selector);
        rule.weight = rule.element.empty() ? 0 : 1;
    }
    while (selector.starts_with('.') || selector.starts_with('#')) {
        const bool is_id = selector.front() == '#';
        selector.remove_prefix(1);
        const std::string_view name = consume_name(selector);
        if (name.empty()) return {};
        if (is_id) {
            rule.id = name;
        } else {
            rule.classes.emplace_back(name);
        }
        rule.weight += is_id ? kIdSpecificity : kClassSpecificity;
    }
    if (!selector.empty()) return {};
    return rule;
}

void SvgStyles::add_rule(std::string_view selectors, std::string_view declarations) {
    const auto unsupported_selectors = [this](std::string_view selector) {
        if (unsupported_selectors_.size() >= kMaxListed) return;
        std::string display_text(selector.substr(0, kMaxSelectorLength));
        std::replace_if(
            display_text.begin(), display_text.end(),
            [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
        unsupported_selectors_.push_back(std::move(display_text));
    };
    if (selectors.starts_with('@')) {  // rules for some media, in their own block
        for (const std::string_view property : kProperties) {
            if (declarations.find(property) != std::string_view::npos)
                return unsupported_selectors(selectors);
        }
        return;
    }
    for (const std::string_view property : kProperties) {
        const std::string_view value = declaration_value(declarations, property);
        for (std::string_view list = selectors; !value.empty() && !list.empty();) {
            const std::string_view selector = trim_blanks(consume_until(list, ','));
            std::optional<Rule> rule = parse_selector(selector);
            if (!rule || rules_.size() >= kMaxRules) {
                unsupported_selectors(selector);
                continue;
            }
            rule->property = property;
            rule->value = value;
            rules_.push_back(*std::move(rule));
        }
    }
}

std::string_view SvgStyles::property(const pugi::xml_node& node, std::string_view name) const {
    const std::string_view declared_value = declaration_value(node.attribute("style").value(), name);
    if (!declared_value.empty()) return declared_value;
    const Rule* found = nullptr;
    for (const Rule& rule : rules_) {
        if (rule.property == name && (found == nullptr || rule.weight >= found->weight) &&
            rule.matches(node)) {
            found = &rule;
        }
    }
    if (found != nullptr) return found->value;
    return node.attribute(std::string(name).c_str()).value();
}

}  // namespace gsim::drawing
