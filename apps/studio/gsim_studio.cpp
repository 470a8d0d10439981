// gsim-studio: serves the page of the studio, with the engine of this computer.

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/programs.h"
#include "apps/studio/served_names.h"
#include "base/os/installation.h"
#include "base/text/json.h"
#include "cli/exit_status.h"
#include "cli/usage_error.h"
#include "cli/version.h"
#include "engine/request.h"

namespace gsim::apps {

namespace {

namespace fs = std::filesystem;
using engine::NameKind;

constexpr const char* kStudio = "gsim-studio";
constexpr const char* kServedPage = "studio/served.html";
constexpr double kMaxPort = 65535;

struct StudioArguments {
    std::vector<std::string> paths;
    std::string machine, machine_data, cell, robots, dialect, module;
    std::uint64_t port = 0;
    bool no_browser = false;
};

void add_studio_options(CommandLine& line, StudioArguments& a) {
    line.add("part.nc|part.lua|folder", &a.paths, "a program to begin with, a folder to work in, or both")
        .takes_file(FileKind::input, {".nc", ".ngc", ".lua"});
    line.begin_group("What it begins with");
    line.add("--machine", &a.machine, "machine file, or settings of a control")
        .takes_file(FileKind::input, {".toml", ".ini"})
        .or_builtin_name();
    line.add("--machine-data", &a.machine_data, "what the control stores")
        .takes_file(FileKind::input, {".txt"});
    line.add("--cell", &a.cell, "what stands round the machine").takes_file(FileKind::input, {".toml"});
    line.add("--robots", &a.robots, "several robots on one clock").takes_file(FileKind::input, {".toml"});
    line.add("--dialect", &a.dialect,
             "language of part programs: ab9, rs274ngc, klipper, or the name of a control; without it that "
             "of the "
             "machine file, else ab9")
        .suggest_values(engine::controller_names());
    line.add("--rcs", &a.module, "controller module that plans the motion")
        .takes_file(FileKind::input)
        .or_builtin_name();
    line.begin_group("Server");
    line.add("--port", &a.port, "of this machine; 0: one that is free").within(0, kMaxPort).show_default();
    line.add("--no-browser", &a.no_browser, "print the address, and open nothing");
    line.add_example("gsim studio part.nc", "run a program, see it, change it; in a browser");
    line.add_example("gsim studio --machine mine.toml ~/programs", "work in a folder");
    line.add_note(
        "The page is served to this machine alone, at an address that nobody can guess, and reads and writes "
        "files of the folder alone (of the program, where none is named; links are not followed). Ctrl+C "
        "ends "
        "it.");
}

struct NamedPaths {
    std::string program, folder;
};

tl::expected<NamedPaths, std::string> classify_paths(const std::vector<std::string>& all) {
    NamedPaths paths;
    for (const std::string& name : all) {
        std::error_code ignored;
        std::string& target_path = fs::is_directory(name, ignored) ? paths.folder : paths.program;
        if (!target_path.empty())
            return tl::unexpected(
                fmt::format("'{}' and '{}': one program and one folder are enough", target_path, name));
        target_path = name;
    }
    return paths;
}

tl::expected<nlohmann::ordered_json, std::string> make_setup(const StudioArguments& arguments,
                                                             const std::string& program,
                                                             const fs::path& folder) {
    nlohmann::ordered_json setup{{"dialect", arguments.dialect}};
    struct File {
        const char* key;
        NameKind kind;
        const std::string& name;
    };
    for (const File& file :
         {File{"program", NameKind::sample, program}, File{"machine", NameKind::machine, arguments.machine},
          File{"machine_data", NameKind::sample, arguments.machine_data},
          File{"cell", NameKind::sample, arguments.cell},
          File{"robots", NameKind::sample, arguments.robots}}) {
        if (file.name.empty()) continue;
        auto name = served_name(folder, file.kind, file.name);
        if (!name) return tl::unexpected(name.error());
        setup[file.key] = *name;
    }
    return setup;
}

tl::expected<fs::path, std::string> installed_page() {
    for (const fs::path& folder : os::data_folders(os::program_folder())) {
        std::error_code ignored;
        if (fs::exists(folder / kServedPage, ignored)) return folder / kServedPage;
    }
    return tl::unexpected(std::string("this build has no page of the studio; make studio makes it"));
}

/// Returns the command line of gsim-serve with its path.
tl::expected<std::vector<std::string>, std::string> server_command(const StudioArguments& arguments) {
    if (!arguments.dialect.empty()) {
        if (const auto reason = engine::find_controller_error(arguments.dialect))
            return tl::unexpected(*reason);
    }
    const auto paths = classify_paths(arguments.paths);
    if (!paths) return tl::unexpected(paths.error());
    std::error_code error;
    const fs::path folder = fs::canonical(served_folder(paths->folder, paths->program), error);
    if (error) return tl::unexpected(fmt::format("'{}' is no folder: {}", paths->folder, error.message()));
    const auto setup = make_setup(arguments, paths->program, folder);
    if (!setup) return tl::unexpected(setup.error());
    const auto page = installed_page();
    if (!page) return tl::unexpected(page.error());
    const fs::path programs = os::program_folder();
    const auto server = os::helper_program(programs, "gsim-serve");
    if (!server) return tl::unexpected(server.error());
    nlohmann::ordered_json engine{(programs / "gsim").string(), "studio-answer", "--folder", folder.string()};
    if (!arguments.module.empty()) {
        const auto module = served_module(arguments.module);
        if (!module) return tl::unexpected(module.error());
        engine.push_back("--rcs");
        engine.push_back(*module);
    }
    const nlohmann::ordered_json page_setup{
        {"folder", folder.filename().string()}, {"setup", *setup}, {"version", version()}};
    const nlohmann::ordered_json all{{"folder", folder.string()}, {"port", arguments.port},
                                     {"page", page->string()},    {"told", page_setup},
                                     {"engine", engine},          {"browser", !arguments.no_browser}};
    using Json = nlohmann::ordered_json;
    return std::vector<std::string>{server->string(),
                                    all.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

int serve(const StudioArguments& arguments) {
    auto command = server_command(arguments);
    if (!command) return usage_error(kStudio, command.error());
    std::vector<char*> words;
    for (std::string& word : *command) words.push_back(word.data());
    words.push_back(nullptr);
    ::execv(words.front(), words.data());
    return usage_error(kStudio, fmt::format("{} cannot be begun: {}", command->front(),
                                            std::generic_category().message(errno)));
}

}  // namespace

std::unique_ptr<Program> make_gsim_studio() {
    return std::make_unique<ProgramWithArguments<StudioArguments>>(
        kStudio, "Shows a machine run a program, and changes both, in a browser", add_studio_options, serve);
}

}  // namespace gsim::apps
