#include "cli/command_line.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text/format.h"

namespace gsim::apps {

namespace {

std::string value_text(const Target& target) {
    return std::visit(
        [](const auto* value) -> std::string {
            using Value = std::decay_t<decltype(*value)>;
            if constexpr (std::is_same_v<Value, std::string>) return *value;
            if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::uint64_t>)
                return fmt::format("{}", *value);
            if constexpr (std::is_same_v<Value, std::array<double, 3>>) return text::joined(*value, " ");
            return {};
        },
        target);
}

}  // namespace

std::string_view Option::long_name() const {
    return std::string_view(names).substr(names.find(',') == std::string::npos ? 0 : names.find(',') + 1);
}

std::string_view Option::short_name() const {
    const std::size_t comma = names.find(',');
    return comma == std::string::npos ? std::string_view{} : std::string_view(names).substr(0, comma);
}

Option& Option::with_value_name(std::string value_name) {
    value = std::move(value_name);
    return *this;
}

Option& Option::within(double min, double max) {
    range = Range{min, max};
    return *this;
}

Option& Option::make_positive() {
    positive = true;
    return *this;
}

Option& Option::one_of(std::vector<std::string> words) {
    choices = std::move(words);
    return *this;
}

Option& Option::takes_file(FileKind kind, std::vector<std::string> extensions_allowed) {
    file = kind;
    extensions = std::move(extensions_allowed);
    return *this;
}

Option& Option::or_builtin_name() {
    allows_name = true;
    return *this;
}

Option& Option::may_share_file_with(std::string other) {
    shares_file_with = std::move(other);
    return *this;
}

Option& Option::suggest_values(std::vector<std::string> words) {
    suggestions = std::move(words);
    return *this;
}

Option& Option::describe_default(std::string text) {
    default_text = std::move(text);
    return *this;
}

Option& Option::show_default() {
    return describe_default(value_text(target));
}

Option& Option::make_required() {
    required = true;
    return *this;
}

Option& Option::exclude_option(std::string other) {
    excluded_option = std::move(other);
    return *this;
}

Option& Option::formerly(std::string old_name) {
    former_name = std::move(old_name);
    return *this;
}

Option& CommandLine::add(std::string names, Target target, std::string help) {
    Option option{.names = std::move(names), .target = target, .help = std::move(help)};
    option.group = option.is_argument() ? "Arguments" : group_;
    return options_.emplace_back(std::move(option));
}

CommandLine& CommandLine::add_command(std::string name, std::string description,
                                      std::function<void()> on_selected) {
    CommandLine& command = commands_.emplace_back(std::move(name), std::move(description));
    command.on_selected_ = std::move(on_selected);
    return command;
}

std::vector<std::string> CommandLine::groups() const {
    std::vector<std::string> found;
    for (const Option& option : options_) {
        if (std::find(found.begin(), found.end(), option.group) == found.end()) found.push_back(option.group);
    }
    // Arguments come first, in any order of adding.
    std::stable_partition(found.begin(), found.end(),
                          [](const std::string& group) { return group == "Arguments"; });
    return found;
}

std::string CommandLine::usage() const {
    std::string text = program_ + " [options]";
    for (const Option& option : options_) {
        if (!option.is_argument()) continue;
        const bool many = std::holds_alternative<std::vector<std::string>*>(option.target);
        const std::string display_text = option.names + (many ? "..." : "");
        text += option.required ? " " + display_text : " [" + display_text + "]";
    }
    if (!commands_.empty()) text += " COMMAND ...";
    return text;
}

std::string value_name(const Option& option) {
    if (option.is_flag() || option.is_argument()) return {};
    if (!option.value.empty()) return option.value;
    if (!option.choices.empty()) return text::joined(option.choices, "|");
    if (option.file == FileKind::folder) return "FOLDER";
    if (option.file != FileKind::none) return "FILE";
    const bool is_text = std::holds_alternative<std::string*>(option.target) ||
                         std::holds_alternative<std::vector<std::string>*>(option.target);
    return is_text ? "NAME" : "NUMBER";
}

const std::vector<std::string>& completion_values(const Option& option) {
    return option.choices.empty() ? option.suggestions : option.choices;
}

std::string full_help(const Option& option) {
    std::string text = option.help;
    if (option.range) text += fmt::format(" ({} to {})", option.range->min, option.range->max);
    if (option.positive) text += " (more than 0)";
    if (!option.default_text.empty()) text += fmt::format(" [{}]", option.default_text);
    return text;
}

}  // namespace gsim::apps
