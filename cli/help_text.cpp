#include "cli/help_text.h"

#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/text/letter_case.h"

namespace gsim::apps {

namespace {

constexpr std::size_t kWidth = 100;
constexpr std::size_t kHelpColumn = 30;  // start of an option's help text

std::string entry(const std::string& name, const std::string& help) {
    const std::string text = wrap_text(help, kWidth - kHelpColumn, kHelpColumn);
    if (name.size() + 4 > kHelpColumn) return fmt::format("  {}\n{}", name, text);
    return fmt::format("  {:<{}}{}", name, kHelpColumn - 2, text.substr(kHelpColumn));
}

std::string names_text(const Option& option) {
    const std::string value = value_name(option);
    const std::string separator = option.short_name().empty() ? "" : ", ";
    return fmt::format("{}{}{}{}{}", option.short_name(), separator, option.long_name(),
                       value.empty() ? "" : " ", value);
}

std::string option_lists(const CommandLine& line) {
    std::string text;
    for (const std::string& group : line.groups()) {
        text += fmt::format("\n{}:\n", group);
        for (const Option& option : line.options()) {
            if (option.group == group) text += entry(names_text(option), full_help(option));
        }
    }
    return text;
}

std::string command_list(const CommandLine& line) {
    if (line.commands().empty()) return {};
    std::string text = "\nCommands:\n";
    for (const CommandLine& command : line.commands())
        text += entry(command.program(), command.description());
    return text;
}

std::string example_list(const CommandLine& line) {
    if (line.examples().empty()) return {};
    std::string text = "\nExamples:\n";
    for (const Example& example : line.examples())
        text += fmt::format("  {}\n{}", example.command, wrap_text(example.effect, kWidth - 6, 6));
    return text;
}

std::string note_list(const CommandLine& line) {
    std::string text;
    for (const std::string& note : line.notes()) text += "\n" + wrap_text(note, kWidth, 0);
    return text;
}

/// Returns "gsim-data FILE set [options] SECTION ...": the usage of the command, with the part that precedes
/// all commands.
std::string usage_of_command(const CommandLine& line, const CommandLine& command) {
    std::string usage = line.program() + " ";
    for (const Option& option : line.options()) {
        if (option.is_argument()) usage += option.names + " ";
    }
    return usage + command.usage();
}

}  // namespace

std::string wrap_text(const std::string& text, std::size_t width, std::size_t indent) {
    const std::string margin(indent, ' ');
    std::istringstream words(text);
    std::string result;
    std::string line;
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > width)
            result += margin + std::exchange(line, {}) + "\n";
        line += (line.empty() ? "" : " ") + word;
    }
    return result + margin + line + "\n";
}

std::string exit_statuses() {
    return "0 success; 1 error in the program, alarm, limit, or findings of a check; 2 error in options, "
           "files or standard output.";
}

std::string help_text(const CommandLine& line, const CommandLine* selected) {
    const bool is_subcommand = selected != &line;
    const std::string usage = is_subcommand ? usage_of_command(line, *selected) : line.usage();
    std::string description = selected->description() + ".";
    description.replace(0, 1, text::upper(description.substr(0, 1)));
    std::string text = fmt::format("Usage: {}\n\n{}", usage, wrap_text(description, kWidth, 0));
    text += option_lists(*selected);
    if (is_subcommand) text += option_lists(line);
    text += "\nHelp:\n" + entry("-h, --help", "print this help and exit") +
            entry("--version", "print the version and those of components, and exit");
    if (!is_subcommand) text += command_list(line);
    return text + note_list(line) + example_list(line) + "\n" +
           wrap_text("Exit status: " + exit_statuses(), kWidth, 0);
}

}  // namespace gsim::apps
