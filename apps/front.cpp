#include "apps/front.h"

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

constexpr const char* kFront = "gsim";

struct OwnCommand {
    const char* name;
    const char* description;
};

// Commands of gsim itself, for users and for packages.
constexpr OwnCommand kHelp{"help", "tell what gsim, or a command, can be told"};
constexpr OwnCommand kCompletion{"completion", "print the completion for a shell: bash, zsh or fish"};
constexpr OwnCommand kManual{"manual", "print the man page of a command, for man -l -"};

// Internal command, called only by gsim-serve.
constexpr const char* kStudioAnswer = "studio-answer";

int printed(const std::string& text) {
    print(text);
    return kDone;
}

CommandLine front_line(const FrontPrograms& front) {
    CommandLine line(kFront,
                     "Tells what a part program will do on a machine, how long it takes and what goes wrong");
    for (const ProgramEntry& entry : front.programs) {
        const std::string description = entry.make()->command_line().description();
        line.add_command(std::string(entry.command), fmt::format("{} ({})", description, entry.name));
    }
    for (const OwnCommand& own : {kHelp, kCompletion, kManual}) line.add_command(own.name, own.description);
    line.add_example("gsim run part.nc", "simulate a part program; the report");
    line.add_example("gsim check --machine mine.toml *.nc",
                     "what is wrong with these programs on this machine");
    line.add_example("gsim translate part.nc -o part.lua", "as a script, to read and to change");
    line.add_example("gsim path plate.svg --material aluminum --thickness 12 -o plate.path.json",
                     "how a waterjet cuts a drawing out");
    line.add_example("gsim write plate.path.json --dialect rs274ngc -o plate.ngc",
                     "a path as a part program");
    line.add_example("gsim help run", "all that a command can be told");
    return line;
}

const ProgramEntry* find_named(const FrontPrograms& front, const std::string& name) {
    for (const ProgramEntry& entry : front.programs) {
        if (name == entry.name) return &entry;
    }
    return nullptr;
}

// Finds a program by its command or by its name, which some users know better.
const ProgramEntry* find_program(const FrontPrograms& front, const std::string& word) {
    for (const ProgramEntry& entry : front.programs) {
        if (word == entry.command) return &entry;
    }
    return find_named(front, word);
}

// Reports as text or as JSON why a program cannot be run.
int refuse(const ProgramEntry& entry, Arguments arguments, text::DiagnosticKind kind,
           const std::string& why) {
    const bool json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
    Findings findings(std::string(entry.name), {.json = json, .sarif = {}});
    const int status = findings.fail(kind, why);
    if (!json && kind == text::DiagnosticKind::usage)
        tell(fmt::format("{0}: {0} --help tells what there is\n", entry.name));
    return findings.finish(status, Findings::Stream::standard_output);
}

int run_program(const ProgramEntry& entry, Arguments arguments) {
    const std::unique_ptr<Program> program = entry.make();
    const auto parsed = parse(program->command_line(), arguments);
    if (!parsed) return refuse(entry, arguments, text::DiagnosticKind::usage, parsed.error());
    if (*parsed) return **parsed;
    if (const auto conflict = find_file_conflict(program->command_line()))
        return refuse(entry, arguments, text::DiagnosticKind::usage, *conflict);
    return program->run();
}

int unknown_command(const FrontPrograms& front, const std::string& word) {
    const CommandLine line = front_line(front);
    std::vector<std::string_view> known;
    for (const CommandLine& command : line.commands()) known.emplace_back(command.program());
    return usage_error(kFront, fmt::format("there is no command '{}'{}\n{}: gsim --help tells what there is",
                                           word, did_you_mean(word, known), kFront));
}

int print_help(const FrontPrograms& front, Arguments words) {
    if (words.empty() || words.front() == kFront) {
        const CommandLine line = front_line(front);
        return printed(help_text(line, &line));
    }
    const ProgramEntry* entry = find_program(front, words.front());
    if (entry == nullptr) return unknown_command(front, words.front());
    const std::unique_ptr<Program> program = entry->make();
    return printed(help_text(program->command_line(), &program->command_line()));
}

int print_manual(const FrontPrograms& front, Arguments words) {
    std::vector<std::string> pages{kFront};
    for (const ProgramEntry& entry : front.programs) pages.emplace_back(entry.name);
    if (words.empty() || words.front() == kFront) return printed(man_page(front_line(front), pages));
    const ProgramEntry* entry = find_program(front, words.front());
    return entry == nullptr ? unknown_command(front, words.front())
                            : printed(man_page(entry->make()->command_line(), pages));
}

int print_completion(const FrontPrograms& front, Arguments words) {
    std::vector<std::unique_ptr<Program>> made;
    std::vector<CompletedProgram> completed;
    for (const ProgramEntry& entry : front.programs) {
        made.push_back(entry.make());
        completed.push_back({std::string(entry.command), &made.back()->command_line()});
    }
    const std::string shell = words.empty() ? "" : words.front();
    if (shell == "bash") return printed(bash_completion(front_line(front), completed));
    if (shell == "zsh") return printed(zsh_completion(front_line(front), completed));
    if (shell == "fish") return printed(fish_completion(front_line(front), completed));
    return usage_error(kFront, "completion is for bash, zsh or fish; name one of them");
}

int run_command(const FrontPrograms& front, Arguments arguments) {
    if (arguments.empty()) {
        print_help(front, {});
        return kUsage;
    }
    const std::string& word = arguments.front();
    const Arguments rest = arguments.subspan(1);
    if (word == "--help" || word == "-h" || word == kHelp.name) return print_help(front, rest);
    if (word == "--version") return printed(version_text(kFront));
    if (word == kManual.name) return print_manual(front, rest);
    if (word == kCompletion.name) return print_completion(front, rest);
    if (word == kStudioAnswer && front.studio_answer != nullptr) return front.studio_answer(rest);
    const ProgramEntry* entry = find_program(front, word);
    return entry == nullptr ? unknown_command(front, word) : run_program(*entry, rest);
}

}  // namespace

int run_front(const FrontPrograms& front, const std::string& called, std::span<const std::string> arguments) {
    const std::string name = std::filesystem::path(called).filename().string();
    const ProgramEntry* entry = find_named(front, name);
    const auto failed = [&](const char* why) {
        if (entry == nullptr) return usage_error(kFront, why);
        return refuse(*entry, arguments, text::DiagnosticKind::internal, why);
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
