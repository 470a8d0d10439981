// The only unit that includes CLI11, which requires ten seconds to compile.
#include "cli/parse.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/exit_status.h"
#include "cli/help_text.h"
#include "cli/print.h"
#include "cli/suggestion.h"
#include "cli/usage_error.h"
#include "cli/version.h"

namespace gsim::apps {

namespace {

CLI::Option* add_unchecked(CLI::App& app, const Option& option) {
    return std::visit(
        [&](auto* target) -> CLI::Option* {
            using Value = std::decay_t<decltype(*target)>;
            if constexpr (std::is_same_v<Value, bool>) {
                return app.add_flag(option.names, *target, option.help);
            } else {
                CLI::Option* cli_option = app.add_option(option.names, *target, option.help);
                // An option of many values consumes one each time, so that an argument may follow it.
                if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
                    if (!option.is_argument()) cli_option->allow_extra_args(false);
                }
                return cli_option;
            }
        },
        option.target);
}

void add_checks(CLI::Option& cli_option, const Option& option) {
    if (option.required) cli_option.required();
    if (!option.choices.empty()) cli_option.check(CLI::IsMember(option.choices));
    if (option.range) cli_option.check(CLI::Range(option.range->min, option.range->max));
    if (option.positive) cli_option.check(CLI::PositiveNumber);
}

void add_all_options(CLI::App& app, const CommandLine& line) {
    app.set_help_flag("-h,--help", "");
    std::vector<std::pair<CLI::Option*, const Option*>> exclusions;  // once all are there
    for (const Option& option : line.options()) {
        CLI::Option* cli_option = add_unchecked(app, option);
        add_checks(*cli_option, option);
        if (!option.excluded_option.empty()) exclusions.emplace_back(cli_option, &option);
    }
    for (const auto& [cli_option, option] : exclusions)
        cli_option->excludes(app.get_option(option->excluded_option));
    for (const CommandLine& command : line.commands()) {
        CLI::App* cli_option = app.add_subcommand(command.program(), command.description());
        cli_option->fallthrough();
        if (command.on_selected()) cli_option->callback(command.on_selected());
        add_all_options(*cli_option, command);
    }
    if (!line.commands().empty()) app.require_subcommand(1);
}

const CommandLine& selected_command(const CLI::App& app, const CommandLine& line) {
    for (const CommandLine& command : line.commands()) {
        if (app.got_subcommand(command.program())) return command;
    }
    return line;
}

void add_words(const CommandLine& line, std::vector<std::string_view>& words) {
    for (const Option& option : line.options()) {
        if (!option.is_argument()) words.push_back(option.long_name());
    }
    for (const CommandLine& command : line.commands()) words.emplace_back(command.program());
}

/// Returns the error of a word that no option accepts.
std::string unknown_word_error(const std::string& word, const CLI::App& app, const CommandLine& line) {
    const bool is_option = word.size() > 1 && word.front() == '-';
    std::vector<std::string_view> known;
    add_words(line, known);
    if (const CommandLine& on_selected = selected_command(app, line); &on_selected != &line)
        add_words(on_selected, known);
    const std::string option_name = word.substr(0, is_option ? word.find('=') : std::string::npos);
    return fmt::format("{} '{}'{}", is_option ? "unknown option" : "unexpected argument", option_name,
                       did_you_mean(option_name, known));
}

/// Returns the error of the arguments, as a message.
std::string argument_error(const CLI::App& app, const CommandLine& line, const std::string& what) {
    const std::vector<std::string> unparsed = app.remaining(true);
    return unparsed.empty() ? what : unknown_word_error(unparsed.front(), app, line);
}

/// Returns the option of a line or of its commands that had a name in the last minor release; null: none.
const Option* find_renamed(const CommandLine& line, std::string_view former_name) {
    for (const Option& option : line.options()) {
        if (option.former_name == former_name) return &option;
    }
    for (const CommandLine& command : line.commands()) {
        if (const Option* option = find_renamed(command, former_name)) return option;
    }
    return nullptr;
}

/// Returns the arguments with the new names of options, and warns of each old one.
std::vector<std::string> renew_names(const CommandLine& line, std::span<const std::string> arguments) {
    std::vector<std::string> renewed(arguments.begin(), arguments.end());
    for (std::string& argument : renewed) {
        if (argument == "--") break;
        const std::string name = argument.substr(0, argument.find('='));
        const Option* option = name.starts_with("--") ? find_renamed(line, name) : nullptr;
        if (option == nullptr) continue;
        report_error(line.program(),
                     fmt::format("warning: {} is named {} now; the old name is an error from 0.3 on", name,
                                 option->long_name()));
        argument.replace(0, name.size(), option->long_name());
    }
    return renewed;
}

}  // namespace

Result<std::optional<int>> parse(const CommandLine& line, std::span<const std::string> arguments) {
    CLI::App app(line.description(), line.program());
    add_all_options(app, line);
    app.set_version_flag("--version", "");
    try {
        std::vector<std::string> last_first = renew_names(line, arguments);
        std::reverse(last_first.begin(), last_first.end());  // as CLI11 expects them
        app.parse(last_first);
    } catch (const CLI::CallForHelp&) {
        print(help_text(line, &selected_command(app, line)));
        return kSuccess;
    } catch (const CLI::CallForVersion&) {
        print(version_text(line.program()));
        return kSuccess;
    } catch (const CLI::ParseError& error) {
        return tl::unexpected(argument_error(app, line, error.what()));
    }
    return std::optional<int>();
}

}  // namespace gsim::apps
