#include <fmt/format.h>

#include "base/text/format.h"
#include "cli/completion.h"
#include "cli/standalone_completion.h"

namespace gsim::apps {

namespace {

std::string fish_quoted(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return "'" + result + "'";
}

// Returns the part of an option's line for its value; empty for a flag.
std::string value_flags(const Option& option) {
    if (option.is_flag()) return "";
    if (!completion_values(option).empty())
        return fmt::format(" -x -a {}", fish_quoted(text::joined(completion_values(option), " ")));
    if (option.file == FileKind::folder) return " -x -a '(__fish_complete_directories)'";
    return option.file == FileKind::none ? " -x" : " -r -F";
}

std::string option_line(const std::string& target_flags, const Option& option) {
    std::string text = fmt::format("complete {} -l {}", target_flags, option.long_name().substr(2));
    if (!option.short_name().empty()) text += fmt::format(" -s {}", option.short_name().substr(1));
    return text + value_flags(option) + " -d " + fish_quoted(option.help) + "\n";
}

std::string option_lines(const std::string& target_flags, const CommandLine& line) {
    std::string text;
    for (const Option& option : line.options()) {
        if (!option.is_argument()) text += option_line(target_flags, option);
    }
    for (const CommandLine& command : line.commands()) {
        text += fmt::format("complete {} -a {} -d {}\n", target_flags, command.program(),
                            fish_quoted(command.description()));
        text += option_lines(target_flags, command);
    }
    return text;
}

}  // namespace

std::string standalone_fish_completion(const CommandLine& line) {
    return fmt::format("# Completion of {0} for fish; made by `{0} completion fish`.\n\n{1}", line.program(),
                       option_lines("-c " + line.program(), line));
}

std::string fish_completion(const CommandLine& front, std::span<const CompletedProgram> programs) {
    std::string text = "# Completion of gsim and its programs for fish; made by `gsim completion fish`.\n\n";
    for (const CommandLine& command : front.commands()) {
        text += fmt::format("complete -c gsim -f -n __fish_use_subcommand -a {} -d {}\n", command.program(),
                            fish_quoted(command.description()));
    }
    std::vector<std::string> commands;
    for (const CompletedProgram& program : programs) commands.push_back(program.command);
    text += "complete -c gsim -x -n '__fish_seen_subcommand_from completion' -a 'bash zsh fish'\n";
    text += fmt::format("complete -c gsim -x -n '__fish_seen_subcommand_from help manual' -a '{}'\n",
                        text::joined(commands, " "));
    for (const CompletedProgram& program : programs) {
        const CommandLine& line = *program.line;
        text += fmt::format("\n{}", option_lines("-c " + line.program(), line));
        text +=
            option_lines(fmt::format("-c gsim -n '__fish_seen_subcommand_from {}'", program.command), line);
    }
    return text;
}

}  // namespace gsim::apps
