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
    line.add("part.nc|part.lua|folder", &a.paths, "program to open, folder to work in, or both")
        .takes_file(FileKind::input, {".nc", ".ngc", ".lua"});
    line.begin_group("Initial files");
    line.add("--machine", &a.machine, "machine file, or settings of a controller")
        .takes_file(FileKind::input, {".toml", ".ini"})
        .or_builtin_name();
    line.add("--machine-data", &a.machine_data, "machine data of the controller")
        .takes_file(FileKind::input, {".txt"});
    line.add("--cell", &a.cell, "cell file: the surroundings of the machine")
        .takes_file(FileKind::input, {".toml"});
    line.add("--robots", &a.robots, "robots file: several robots with a common clock")
        .takes_file(FileKind::input, {".toml"});
    line.add("--dialect", &a.dialect,
             "language of part programs: ab9, rs274ngc, klipper, or the name of a controller; default: that "
             "of the machine file, else ab9")
        .suggest_values(engine::controller_names());
    line.add("--rcs", &a.module, "controller module that plans the motion")
        .takes_file(FileKind::input)
        .or_builtin_name();
    line.begin_group("Server");
    line.add("--port", &a.port, "port on this computer; 0: any free port").within(0, kMaxPort).show_default();
    line.add("--no-browser", &a.no_browser, "print the address, do not open a browser");
    line.add_example("gsim studio part.nc", "run, view and edit a program in a browser");
    line.add_example("gsim studio --machine mine.toml ~/programs", "work in a folder");
    line.add_note(
        "The page is served only to this computer, at an address that cannot be guessed, and reads and "
        "writes only files in the folder (default: that of the program; links are not followed). Ctrl+C ends "
        "it.");
}

struct NamedPaths {
    std::string program, folder;
};

Result<NamedPaths> classify_paths(const std::vector<std::string>& all) {
    NamedPaths paths;
    for (const std::string& name : all) {
        std::error_code ignored;
        std::string& target_path = fs::is_directory(name, ignored) ? paths.folder : paths.program;
        if (!target_path.empty())
            return Unexpected(
                fmt::format("'{}' and '{}': only one program and one folder are allowed", target_path, name));
        target_path = name;
    }
    return paths;
}

Result<nlohmann::ordered_json> make_setup(const StudioArguments& arguments, const std::string& program,
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

Result<fs::path> installed_page() {
    for (const fs::path& folder : os::data_folders(os::program_folder())) {
        std::error_code ignored;
        if (fs::exists(folder / kServedPage, ignored)) return folder / kServedPage;
    }
    return Unexpected("this build has no Studio page; make studio builds it");
}

/// Returns the command line of gsim-serve with its path.
Result<std::vector<std::string>> server_command(const StudioArguments& arguments) {
    if (!arguments.dialect.empty()) {
        if (const auto reason = engine::find_controller_error(arguments.dialect))
            return tl::unexpected(*reason);
    }
    const auto paths = classify_paths(arguments.paths);
    if (!paths) return tl::unexpected(paths.error());
    std::error_code error;
    const fs::path folder = fs::canonical(served_folder(paths->folder, paths->program), error);
    if (error) return Unexpected(fmt::format("'{}' is not a folder: {}", paths->folder, error.message()));
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
                                     {"page", page->string()},    {"page_data", page_setup},
                                     {"engine", engine},          {"browser", !arguments.no_browser}};
    using Json = nlohmann::ordered_json;
    return std::vector<std::string>{server->string(),
                                    all.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

int serve(const StudioArguments& arguments) {
    auto command = server_command(arguments);
    if (!command) return usage_error(kStudio, command.error().message);
    std::vector<char*> words;
    for (std::string& word : *command) words.push_back(word.data());
    words.push_back(nullptr);
    ::execv(words.front(), words.data());
    return usage_error(kStudio, fmt::format("{} cannot be started: {}", command->front(),
                                            std::generic_category().message(errno)));
}

}  // namespace

std::unique_ptr<Program> make_gsim_studio() {
    return std::make_unique<ProgramWithArguments<StudioArguments>>(
        kStudio, "Simulates a program on a machine, and edits both, in a browser", add_studio_options, serve);
}

}  // namespace gsim::apps
