#include <fmt/format.h>

#include "base/text/format.h"
#include "cli/completion.h"
#include "cli/standalone_completion.h"

namespace gsim::apps {

namespace {

// Returns text for single quotes; it escapes brackets and colons, which _arguments interprets.
std::string zsh_quoted(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else {
            if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result;
}

std::string value_action(const Option& option) {
    if (!completion_values(option).empty())
        return fmt::format("({})", text::joined(completion_values(option), " "));
    if (option.file == FileKind::folder) return "_files -/";
    return option.file == FileKind::none ? " " : "_files";
}

std::string specification(const Option& option) {
    const bool many = std::holds_alternative<std::vector<std::string>*>(option.target);
    if (option.is_argument())
        return fmt::format("'{}:{}:{}'", many ? "*" : "", zsh_quoted(option.names), value_action(option));
    std::string text;
    const std::string value =
        option.is_flag() ? "" : fmt::format(":{}:{}", zsh_quoted(value_name(option)), value_action(option));
    for (const std::string_view name : {option.short_name(), option.long_name()}) {
        if (!name.empty())
            text += fmt::format(" '{}{}[{}]{}'", many ? "*" : "", name, zsh_quoted(option.help), value);
    }
    return text.substr(1);
}

std::string specifications(const CommandLine& line) {
    std::string text;
    for (const Option& option : line.options()) text += " \\\n        " + specification(option);
    return text;
}

std::string arguments_call(const CommandLine& line) {
    std::string text =
        fmt::format("_arguments -s '--help[print help and exit]' '--version[print the version and exit]'{}",
                    specifications(line));
    if (!line.commands().empty()) {
        text += " \\\n        ':command:(";
        for (const CommandLine& command : line.commands()) text += command.program() + " ";
        text.back() = ')';
        text += "'";
        for (const CommandLine& command : line.commands()) {
            for (const Option& option : command.options()) {
                if (!option.is_argument()) text += " \\\n        " + specification(option);
            }
        }
    }
    return text + '\n';
}

std::string program_case(const CompletedProgram& program) {
    return fmt::format("    {}|{})\n        {}        ;;\n", program.command, program.line->program(),
                       arguments_call(*program.line));
}

}  // namespace

std::string standalone_zsh_completion(const CommandLine& line) {
    return fmt::format("#compdef {0}\n# Completion of {0} for zsh; made by `{0} completion zsh`.\n\n{1}",
                       line.program(), arguments_call(line));
}

std::string zsh_completion(const CommandLine& front, std::span<const CompletedProgram> programs) {
    std::string text = "#compdef gsim";
    for (const CompletedProgram& program : programs) text += " " + program.line->program();
    text += "\n# Completion of gsim and its programs for zsh; made by `gsim completion zsh`.\n\n_gsim() {\n";
    text +=
        "    local program=${service:-gsim}\n    if [[ $program == gsim ]]; then\n        if ((CURRENT == "
        "2)); then\n";
    text += "            local -a commands=(\n";
    for (const CommandLine& command : front.commands())
        text += fmt::format("                '{}:{}'\n", zsh_quoted(command.program()),
                            zsh_quoted(command.description()));
    text += "            )\n            _describe command commands\n            return\n        fi\n";
    text +=
        "        program=$words[2]\n        shift words\n        ((CURRENT--))\n    fi\n    case $program "
        "in\n";
    std::vector<std::string> commands;
    for (const CompletedProgram& program : programs) commands.push_back(program.command);
    text += "    completion)\n        _arguments ':shell:(bash zsh fish)'\n        ;;\n";
    text += fmt::format("    help|manual)\n        _arguments ':command:({})'\n        ;;\n",
                        text::joined(commands, " "));
    for (const CompletedProgram& program : programs) text += program_case(program);
    return text + "    esac\n}\n\n_gsim \"$@\"\n";
}

}  // namespace gsim::apps
