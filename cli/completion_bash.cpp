#include <fmt/format.h>

#include "base/text/format.h"
#include "cli/completion.h"
#include "cli/standalone_completion.h"

namespace gsim::apps {

namespace {

// Bash splits --option=value into three words. Names of files may have spaces, so a line is a word.
constexpr const char* kHelpers = R"(_gsim_begin() {
    COMPREPLY=()
    cur=${COMP_WORDS[COMP_CWORD]}
    prev=${COMP_WORDS[COMP_CWORD-1]}
    if [[ $cur == = ]]; then
        cur=
    elif [[ $prev == = ]]; then
        prev=${COMP_WORDS[COMP_CWORD-2]}
    fi
}

_gsim_words() { mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -W "$1" -- "$cur"); }

_gsim_files() {
    mapfile -t COMPREPLY < <(compgen "$1" -- "$cur")
    compopt -o filenames 2>/dev/null
}

)";

// Returns the name of a program's shell function.
std::string function_name(std::string program) {
    for (char& c : program) {
        if (c == '-') c = '_';
    }
    return "_" + program;
}

std::vector<std::string> option_names(const CommandLine& line) {
    std::vector<std::string> names{"--help", "--version"};
    for (const Option& option : line.options()) {
        if (!option.is_argument()) names.emplace_back(option.long_name());
    }
    return names;
}

// Returns the names of options with the same kind of value, as a pattern of `case`.
std::string case_pattern(const Option& option) {
    const std::string separator = option.short_name().empty() ? "" : "|";
    return fmt::format("{}{}{}", option.short_name(), separator, option.long_name());
}

std::string completed_value(const Option& option) {
    if (!completion_values(option).empty())
        return fmt::format("_gsim_words '{}'", text::joined(completion_values(option), " "));
    if (option.file == FileKind::folder) return "_gsim_files -d";
    if (option.file != FileKind::none) return "_gsim_files -f";
    return ":";  // a number, or a name that only the user knows
}

std::string option_cases(const CommandLine& line) {
    std::string text;
    for (const Option& option : line.options()) {
        if (option.is_argument() || option.is_flag()) continue;
        text += fmt::format("        {}) {}; return ;;\n", case_pattern(option), completed_value(option));
    }
    for (const CommandLine& command : line.commands()) text += option_cases(command);
    return text;
}

std::string program_function(const CommandLine& line) {
    std::vector<std::string> words = option_names(line);
    std::string names;
    for (const CommandLine& command : line.commands()) {
        names += " " + command.program();
        for (const Option& option : command.options()) {
            if (!option.is_argument()) words.emplace_back(option.long_name());
        }
    }
    std::string text =
        fmt::format("{}() {{\n    local cur prev\n    _gsim_begin\n", function_name(line.program()));
    text += "    case $prev in\n" + option_cases(line) + "    esac\n";
    text +=
        fmt::format("    if [[ $cur == -* ]]; then _gsim_words '{}'; return; fi\n", text::joined(words, " "));
    text += "    _gsim_files -f\n";
    if (!names.empty()) text += fmt::format("    _gsim_words '{}'\n", names.substr(1));
    return text + fmt::format("}}\ncomplete -F {} {}\n\n", function_name(line.program()), line.program());
}

std::string front_function(const CommandLine& front, std::span<const CompletedProgram> programs) {
    std::vector<std::string> commands;
    for (const CompletedProgram& program : programs) commands.push_back(program.command);
    std::string words = "--help --version";
    for (const CommandLine& command : front.commands()) words += " " + command.program();
    std::string text = "_gsim() {\n    local cur prev\n    _gsim_begin\n";
    text += fmt::format("    if ((COMP_CWORD == 1)); then _gsim_words '{}'; return; fi\n", words);
    text += "    case ${COMP_WORDS[1]} in\n";
    text += fmt::format("        help|manual) _gsim_words '{}' ;;\n", text::joined(commands, " "));
    text += "        completion) _gsim_words 'bash zsh fish' ;;\n";
    for (const CompletedProgram& program : programs)
        text += fmt::format("        {}) {} ;;\n", program.command, function_name(program.line->program()));
    return text + "    esac\n}\ncomplete -F _gsim gsim\n";
}

}  // namespace

std::string standalone_bash_completion(const CommandLine& line) {
    return fmt::format("# Completion of {0} for bash; made by `{0} completion bash`.\n\n{1}{2}",
                       line.program(), kHelpers, program_function(line));
}

std::string bash_completion(const CommandLine& front, std::span<const CompletedProgram> programs) {
    std::string text = "# Completion of gsim and its programs for bash; made by `gsim completion bash`.\n\n";
    text += kHelpers;
    for (const CompletedProgram& program : programs) text += program_function(*program.line);
    return text + front_function(front, programs);
}

}  // namespace gsim::apps
