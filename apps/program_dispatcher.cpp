#include "apps/program_dispatcher.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <vector>

#include <fmt/format.h>

#include "apps/findings.h"
#include "apps/programs.h"
#include "cli/completion.h"
#include "cli/exit_status.h"
#include "cli/help_text.h"
#include "cli/man_page.h"
#include "cli/named_files.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/suggestion.h"
#include "cli/usage_error.h"
#include "cli/version.h"

namespace gsim::apps {

namespace {

using Arguments = std::span<const std::string>;

constexpr const char* kGsim = "gsim";

struct BuiltInCommand {
    const char* name;
    const char* description;
};

// Commands of gsim itself, for users and for packages.
constexpr BuiltInCommand kHelp{"help", "print the help of gsim, or of a command"};
constexpr BuiltInCommand kCompletion{"completion", "print the completion for a shell: bash, zsh or fish"};
constexpr BuiltInCommand kManual{"manual", "print the man page of a command, for man -l -"};

// Internal command, called only by gsim-serve.
constexpr const char* kStudioRequestCommand = "studio-answer";

int print_and_succeed(const std::string& text) {
    print(text);
    return kSuccess;
}

CommandLine gsim_command_line(const ProgramSet& front) {
    CommandLine line(kGsim, "Simulates part programs on a machine: motion, cycle time and errors");
    for (const ProgramEntry& entry : front.programs) {
        const std::string description = entry.make()->command_line().description();
        line.add_command(std::string(entry.command), fmt::format("{} ({})", description, entry.name));
    }
    for (const BuiltInCommand& built_in : {kHelp, kCompletion, kManual})
        line.add_command(built_in.name, built_in.description);
    line.add_example("gsim run part.nc", "simulate a part program and print the report");
    line.add_example("gsim check --machine mine.toml *.nc",
                     "print the errors of these programs on this machine");
    line.add_example("gsim translate part.nc -o part.lua", "as a script, to read and to edit");
    line.add_example("gsim path plate.svg --material aluminum --thickness 12 -o plate.path.json",
                     "the waterjet path of a drawing");
    line.add_example("gsim write plate.path.json --dialect rs274ngc -o plate.ngc",
                     "a path as a part program");
    line.add_example("gsim help run", "all options of a command");
    return line;
}

const ProgramEntry* find_by_name(const ProgramSet& front, const std::string& name) {
    for (const ProgramEntry& entry : front.programs) {
        if (name == entry.name) return &entry;
    }
    return nullptr;
}

// Finds a program by its command or by its name, which some users know better.
const ProgramEntry* find_program(const ProgramSet& front, const std::string& word) {
    for (const ProgramEntry& entry : front.programs) {
        if (word == entry.command) return &entry;
    }
    return find_by_name(front, word);
}

// Reports as text or as JSON why a program cannot be run.
int report_error_of(const ProgramEntry& entry, Arguments arguments, text::DiagnosticKind kind,
                    const std::string& message) {
    const bool json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
    Findings findings(std::string(entry.name), {.json = json, .sarif = {}});
    const int status = findings.fail(kind, message);
    if (!json && kind == text::DiagnosticKind::usage)
        print_to_standard_error(fmt::format("{0}: see {0} --help\n", entry.name));
    return findings.finish(status, Findings::Stream::standard_output);
}

int run_program(const ProgramEntry& entry, Arguments arguments) {
    const std::unique_ptr<Program> program = entry.make();
    const auto parsed = parse(program->command_line(), arguments);
    if (!parsed)
        return report_error_of(entry, arguments, text::DiagnosticKind::usage, parsed.error().message);
    if (*parsed) return **parsed;
    if (const auto conflict = find_file_conflict(program->command_line()))
        return report_error_of(entry, arguments, text::DiagnosticKind::usage, conflict->message);
    return program->run();
}

int unknown_command(const ProgramSet& front, const std::string& word) {
    const CommandLine line = gsim_command_line(front);
    std::vector<std::string_view> known;
    for (const CommandLine& command : line.commands()) known.emplace_back(command.program());
    return usage_error(kGsim, fmt::format("unknown command '{}'{}\n{}: see gsim --help", word,
                                          did_you_mean(word, known), kGsim));
}

int print_help(const ProgramSet& front, Arguments words) {
    if (words.empty() || words.front() == kGsim) {
        const CommandLine line = gsim_command_line(front);
        return print_and_succeed(help_text(line, &line));
    }
    const ProgramEntry* entry = find_program(front, words.front());
    if (entry == nullptr) return unknown_command(front, words.front());
    const std::unique_ptr<Program> program = entry->make();
    return print_and_succeed(help_text(program->command_line(), &program->command_line()));
}

int print_manual(const ProgramSet& front, Arguments words) {
    std::vector<std::string> pages{kGsim};
    for (const ProgramEntry& entry : front.programs) pages.emplace_back(entry.name);
    if (words.empty() || words.front() == kGsim)
        return print_and_succeed(man_page(gsim_command_line(front), pages));
    const ProgramEntry* entry = find_program(front, words.front());
    return entry == nullptr ? unknown_command(front, words.front())
                            : print_and_succeed(man_page(entry->make()->command_line(), pages));
}

int print_completion(const ProgramSet& front, Arguments words) {
    std::vector<std::unique_ptr<Program>> instances;
    std::vector<CompletedProgram> completed;
    for (const ProgramEntry& entry : front.programs) {
        instances.push_back(entry.make());
        completed.push_back({std::string(entry.command), &instances.back()->command_line()});
    }
    const std::string shell = words.empty() ? "" : words.front();
    if (shell == "bash") return print_and_succeed(bash_completion(gsim_command_line(front), completed));
    if (shell == "zsh") return print_and_succeed(zsh_completion(gsim_command_line(front), completed));
    if (shell == "fish") return print_and_succeed(fish_completion(gsim_command_line(front), completed));
    return usage_error(kGsim, "completion supports bash, zsh or fish; name one of them");
}

int run_command(const ProgramSet& front, Arguments arguments) {
    if (arguments.empty()) {
        print_help(front, {});
        return kUsageError;
    }
    const std::string& word = arguments.front();
    const Arguments remaining = arguments.subspan(1);
    if (word == "--help" || word == "-h" || word == kHelp.name) return print_help(front, remaining);
    if (word == "--version") return print_and_succeed(version_text(kGsim));
    if (word == kManual.name) return print_manual(front, remaining);
    if (word == kCompletion.name) return print_completion(front, remaining);
    if (word == kStudioRequestCommand && front.studio_handler != nullptr)
        return front.studio_handler(remaining);
    const ProgramEntry* entry = find_program(front, word);
    return entry == nullptr ? unknown_command(front, word) : run_program(*entry, remaining);
}

}  // namespace

int dispatch_program(const ProgramSet& front, const std::string& invoked_name,
                     std::span<const std::string> arguments) {
    const std::string name = std::filesystem::path(invoked_name).filename().string();
    const ProgramEntry* entry = find_by_name(front, name);
    const auto failed = [&](const char* message) {
        if (entry == nullptr) return usage_error(kGsim, message);
        return report_error_of(*entry, arguments, text::DiagnosticKind::internal, message);
    };
    try {
        return entry == nullptr ? run_command(front, arguments) : run_program(*entry, arguments);
    } catch (const std::bad_alloc&) {
        return failed("out of memory");
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}

}  // namespace gsim::apps
