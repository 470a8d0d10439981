#include "apps/confine_run.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/os/installation.h"
#include "base/os/output_file.h"
#include "engine/run.h"

namespace gsim::apps {

namespace fs = std::filesystem;

namespace {

/// The leak search at the end of a program that is built with sanitizers reads from its own process.
#ifdef GSIM_SANITIZED
constexpr bool kLooksAtItself = true;
#else
constexpr bool kLooksAtItself = false;
#endif

/// Folder in which a program that is built for measuring coverage adds up its counts, when it ends.
#ifdef GSIM_COUNTS_FOLDER
constexpr const char* kCountsFolder = GSIM_COUNTS_FOLDER;
#else
constexpr const char* kCountsFolder = nullptr;
#endif

/// A file is created next to its target, which may be at the end of a link.
void add_output(const std::string& name, os::Allowed& allowed) {
    if (name.empty() || name == os::kStandardStream) return;
    std::error_code ignored;
    if (fs::exists(name, ignored) && !fs::is_regular_file(name, ignored)) {
        allowed.written.emplace_back(name);
        return;
    }
    allowed.changed.push_back(fs::weakly_canonical(fs::absolute(name), ignored).parent_path());
}

/// Adds the needs of gnuplot: itself, its libraries, fonts and their settings.
void add_programs_of_system(os::Allowed& allowed) {
    for (const char* folder : {"/usr", "/bin", "/lib", "/lib64", "/etc", "/opt", "/var/cache/fontconfig"})
        allowed.run.emplace_back(folder);
    allowed.written.emplace_back("/dev/null");
    allowed.read.emplace_back("/dev/null");
    const char* const path = std::getenv("PATH");
    std::string_view rest = path == nullptr ? "" : path;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        if (end > 0) allowed.run.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
}

tl::expected<void, std::string> give_up_all_but(os::Allowed allowed) {
    if (kLooksAtItself) allowed.read.emplace_back("/proc/self");
    if (kCountsFolder != nullptr) allowed.changed.emplace_back(kCountsFolder);
    return os::confine(allowed).map([](bool) {}).map_error([](const std::string& sentence) {
        return sentence + "; --no-confine runs without";
    });
}

}  // namespace

os::Allowed allowed_to(const RunArguments& arguments, const engine::Request& request,
                       std::span<const std::string> programs) {
    os::Allowed allowed;
    for (const std::string& program : programs) allowed.read.push_back(engine::program_folder(program));
    for (const std::string* name : {&request.library, &request.machine_data, &request.setup,
                                    &request.overrides.file, &request.variables}) {
        if (!name->empty()) allowed.read.emplace_back(*name);
    }
    const OutputNames& outputs = arguments.outputs;
    for (const OutputNames::File& file : OutputNames::files()) add_output(outputs.*file.name, allowed);
    for (const std::string* name :
         {&arguments.findings.sarif, &request.variables, &arguments.save_machine_data})
        add_output(*name, allowed);
    if (!outputs.plot.empty()) add_programs_of_system(allowed);
    return allowed;
}

tl::expected<void, std::string> confine_run(const RunArguments& arguments, const engine::Request& request,
                                            std::span<const std::string> programs) {
    // A module in a separate process was started before this, and is not confined.
    if (arguments.no_confine || (arguments.module_in_process && !request.module.empty())) return {};
    return give_up_all_but(allowed_to(arguments, request, programs));
}

tl::expected<void, std::string> confine_to(std::span<const std::string> files,
                                           std::span<const std::string> outputs) {
    os::Allowed allowed;
    for (const std::string& file : files) {
        if (!file.empty() && file != os::kStandardStream) allowed.read.emplace_back(file);
    }
    for (const std::string& output : outputs) add_output(output, allowed);
    return give_up_all_but(std::move(allowed));
}

tl::expected<void, std::string> confine_to_folders(std::span<const fs::path> folders) {
    os::Allowed allowed;
    allowed.read.assign(folders.begin(), folders.end());
    add_programs_of_system(allowed);
    const fs::path programs = os::program_folder();
    allowed.run.push_back(programs);
    allowed.run.push_back(programs.parent_path() / "libexec");
    std::error_code ignored;
    allowed.changed.push_back(fs::temp_directory_path(ignored));  // long texts are kept there meanwhile
    return give_up_all_but(std::move(allowed));
}

void add_confine_option(CommandLine& line, bool& no_confine) {
    line.add(
        "--no-confine", &no_confine,
        "do not take from the program, before it reads its input, what it does not need: all other files but "
        "those in the folders of its outputs, other programs, the network (Linux, landlock)");
}

}  // namespace gsim::apps
