// The only unit that includes CLI11, which requires ten seconds to compile.
#include "cli/parse.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/exit_status.h"
#include "cli/help_text.h"
#include "cli/print.h"
#include "cli/suggestion.h"
#include "cli/version.h"

namespace gsim::apps {

namespace {

CLI::Option* add_bare(CLI::App& app, const Option& option) {
    return std::visit(
        [&](auto* target) -> CLI::Option* {
            using Value = std::decay_t<decltype(*target)>;
            if constexpr (std::is_same_v<Value, bool>) {
                return app.add_flag(option.names, *target, option.help);
            } else {
                CLI::Option* added = app.add_option(option.names, *target, option.help);
                // An option of many values consumes one each time, so that an argument may follow it.
                if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
                    if (!option.is_argument()) added->allow_extra_args(false);
                }
                return added;
            }
        },
        option.target);
}

void add_checks(CLI::Option& added, const Option& option) {
    if (option.required) added.required();
    if (!option.choices.empty()) added.check(CLI::IsMember(option.choices));
    if (option.range) added.check(CLI::Range(option.range->least, option.range->most));
    if (option.positive) added.check(CLI::PositiveNumber);
}

void fill(CLI::App& app, const CommandLine& line) {
    app.set_help_flag("-h,--help", "");
    std::vector<std::pair<CLI::Option*, const Option*>> excluding;  // once all are there
    for (const Option& option : line.options()) {
        CLI::Option* added = add_bare(app, option);
        add_checks(*added, option);
        if (!option.excludes.empty()) excluding.emplace_back(added, &option);
    }
    for (const auto& [added, option] : excluding) added->excludes(app.get_option(option->excludes));
    for (const CommandLine& command : line.commands()) {
        CLI::App* added = app.add_subcommand(command.program(), command.description());
        added->fallthrough();
        if (command.chosen()) added->callback(command.chosen());
        fill(*added, command);
    }
    if (!line.commands().empty()) app.require_subcommand(1);
}

const CommandLine& chosen_command(const CLI::App& app, const CommandLine& line) {
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
std::string unknown_word(const std::string& word, const CLI::App& app, const CommandLine& line) {
    const bool is_option = word.size() > 1 && word.front() == '-';
    std::vector<std::string_view> known;
    add_words(line, known);
    if (const CommandLine& chosen = chosen_command(app, line); &chosen != &line) add_words(chosen, known);
    const std::string bare = word.substr(0, is_option ? word.find('=') : std::string::npos);
    return fmt::format("{} '{}'{}", is_option ? "there is no option" : "nothing takes", bare,
                       did_you_mean(bare, known));
}

/// Returns the error of the arguments, as a message.
std::string mistake(const CLI::App& app, const CommandLine& line, const std::string& what) {
    const std::vector<std::string> left = app.remaining(true);
    return left.empty() ? what : unknown_word(left.front(), app, line);
}

}  // namespace

tl::expected<std::optional<int>, std::string> parse(const CommandLine& line,
                                                    std::span<const std::string> arguments) {
    CLI::App app(line.description(), line.program());
    fill(app, line);
    app.set_version_flag("--version", "");
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(),
                                           arguments.rend()));  // CLI11 wants the last one first
    } catch (const CLI::CallForHelp&) {
        print(help_text(line, &chosen_command(app, line)));
        return kDone;
    } catch (const CLI::CallForVersion&) {
        print(version_text(line.program()));
        return kDone;
    } catch (const CLI::ParseError& error) {
        return tl::unexpected(mistake(app, line, error.what()));
    }
    return std::optional<int>();
}

}  // namespace gsim::apps
