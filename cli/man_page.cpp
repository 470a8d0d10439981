#include "cli/man_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "cli/help_text.h"
#include "cli/version.h"

namespace gsim::apps {

namespace {

// Returns text that roff prints unchanged. A backslash begins an escape, a bare hyphen may become a dash, a
// quote a curved one. A dot in front turns a line into a request.
std::string escape_roff(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if (c == '\'') {
            result += "\\(aq";  // in a command to copy, not a typographer's
        } else {
            result += c;
        }
    }
    if (result.starts_with('.')) result.insert(0, "\\&");
    return result;
}

std::string roff_sentence(std::string text) {
    if (!text.ends_with('.')) text += '.';
    return escape_roff(text);
}

std::string tagged_names(const Option& option) {
    std::string text;
    if (!option.short_name().empty()) text = fmt::format("\\fB{}\\fR, ", escape_roff(option.short_name()));
    text += fmt::format("\\fB{}\\fR", escape_roff(option.long_name()));
    const std::string value = value_name(option);
    return value.empty() ? text : fmt::format("{} \\fI{}\\fR", text, escape_roff(value));
}

std::string option_section(const CommandLine& line) {
    std::string text;
    for (const std::string& group : line.groups()) {
        text += fmt::format(".SS {}\n", escape_roff(group));
        for (const Option& option : line.options()) {
            if (option.group == group)
                text += fmt::format(".TP\n{}\n{}\n", tagged_names(option), roff_sentence(full_help(option)));
        }
    }
    return text;
}

std::string command_section(const CommandLine& line) {
    if (line.commands().empty()) return {};
    std::string text = ".SH COMMANDS\n";
    for (const CommandLine& command : line.commands()) {
        text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", escape_roff(command.program()),
                            roff_sentence(command.description()));
        for (const Option& option : command.options())
            text += fmt::format(".RS\n.TP\n{}\n{}\n.RE\n", tagged_names(option),
                                roff_sentence(full_help(option)));
    }
    return text;
}

std::string example_section(const CommandLine& line) {
    if (line.examples().empty()) return {};
    std::string text = ".SH EXAMPLES\n";
    for (const Example& example : line.examples())
        text +=
            fmt::format(".TP\n\\fB{}\\fR\n{}\n", escape_roff(example.command), roff_sentence(example.effect));
    return text;
}

std::string see_also(const CommandLine& line, std::span<const std::string> others) {
    std::string text = ".SH SEE ALSO\n";
    std::string separator;
    for (const std::string& other : others) {
        if (other == line.program()) continue;
        text += fmt::format("{}.BR {} (1)", separator, escape_roff(other));
        separator = ",\n";
    }
    return text + "\n";
}

}  // namespace

std::string man_page(const CommandLine& line, std::span<const std::string> others) {
    std::string text =
        fmt::format(".TH {} 1 {} \"gsim {}\" \"User Commands\"\n", escape_roff(text::upper(line.program())),
                    escape_roff(release_date()), version());
    // The index of man pages shows a short form of a description: its first clause, without a capital letter.
    std::string short_description = line.description().substr(0, line.description().find(':'));
    short_description = text::lower(short_description.substr(0, 1)) + short_description.substr(1);
    text += fmt::format(".SH NAME\n{} \\- {}\n", escape_roff(line.program()), escape_roff(short_description));
    text += fmt::format(".SH SYNOPSIS\n.B {}\n{}\n", escape_roff(line.program()),
                        escape_roff(line.usage().substr(line.program().size() + 1)));
    text += fmt::format(".SH DESCRIPTION\n{}\n", roff_sentence(line.description()));
    for (const std::string& note : line.notes()) text += fmt::format(".PP\n{}\n", escape_roff(note));
    if (!line.options().empty()) text += ".SH OPTIONS\n" + option_section(line);
    text += command_section(line) + example_section(line);
    text += fmt::format(".SH EXIT STATUS\n{}\n", escape_roff(exit_statuses()));
    return text + see_also(line, others);
}

}  // namespace gsim::apps
