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
constexpr bool kReadsProcSelf = true;
#else
constexpr bool kReadsProcSelf = false;
#endif

/// Folder in which a program that is built for measuring coverage adds up its counts, when it ends.
#ifdef GSIM_COUNTS_FOLDER
constexpr const char* kCoverageFolder = GSIM_COUNTS_FOLDER;
#else
constexpr const char* kCoverageFolder = nullptr;
#endif

/// A file is created next to its target, which may be at the end of a link.
void add_output(const std::string& name, os::SandboxPolicy& policy) {
    if (name.empty() || name == os::kStandardStream) return;
    std::error_code ignored;
    if (fs::exists(name, ignored) && !fs::is_regular_file(name, ignored)) {
        policy.written.emplace_back(name);
        return;
    }
    policy.changed.push_back(fs::weakly_canonical(fs::absolute(name), ignored).parent_path());
}

/// Adds the needs of gnuplot: itself, its libraries, fonts and their settings.
void add_system_programs(os::SandboxPolicy& policy) {
    for (const char* folder : {"/usr", "/bin", "/lib", "/lib64", "/etc", "/opt", "/var/cache/fontconfig"})
        policy.run.emplace_back(folder);
    policy.written.emplace_back("/dev/null");
    policy.read.emplace_back("/dev/null");
    const char* const path = std::getenv("PATH");
    std::string_view remaining_path = path == nullptr ? "" : path;
    while (!remaining_path.empty()) {
        const std::size_t end = std::min(remaining_path.find(':'), remaining_path.size());
        if (end > 0) policy.run.emplace_back(remaining_path.substr(0, end));
        remaining_path.remove_prefix(std::min(end + 1, remaining_path.size()));
    }
}

Result<void> restrict_access(os::SandboxPolicy policy) {
    if (kReadsProcSelf) policy.read.emplace_back("/proc/self");
    if (kCoverageFolder != nullptr) policy.changed.emplace_back(kCoverageFolder);
    return os::confine(policy).map([](bool) {}).map_error([](const Error& error) {
        return Error(error.message + "; --no-confine runs without confinement");
    });
}

}  // namespace

os::SandboxPolicy run_sandbox_policy(const RunArguments& arguments, const engine::Request& request,
                                     std::span<const std::string> programs) {
    os::SandboxPolicy policy;
    for (const std::string& program : programs) policy.read.push_back(engine::program_folder(program));
    for (const std::string* name : {&request.library, &request.machine_data, &request.setup,
                                    &request.overrides.file, &request.variables}) {
        if (!name->empty()) policy.read.emplace_back(*name);
    }
    const OutputNames& outputs = arguments.outputs;
    for (const OutputNames::File& file : OutputNames::files()) add_output(outputs.*file.name, policy);
    for (const std::string* name :
         {&arguments.findings.sarif, &request.variables, &arguments.save_machine_data})
        add_output(*name, policy);
    if (!outputs.plot.empty()) add_system_programs(policy);
    return policy;
}

Result<void> confine_run(const RunArguments& arguments, const engine::Request& request,
                         std::span<const std::string> programs) {
    // A module in a separate process was started before this, and is not confined.
    if (arguments.no_confine || (arguments.module_in_process && !request.module.empty())) return {};
    return restrict_access(run_sandbox_policy(arguments, request, programs));
}

Result<void> confine_to(std::span<const std::string> files, std::span<const std::string> outputs) {
    os::SandboxPolicy policy;
    for (const std::string& file : files) {
        if (!file.empty() && file != os::kStandardStream) policy.read.emplace_back(file);
    }
    for (const std::string& output : outputs) add_output(output, policy);
    return restrict_access(std::move(policy));
}

Result<void> confine_to_folders(std::span<const fs::path> folders) {
    os::SandboxPolicy policy;
    policy.read.assign(folders.begin(), folders.end());
    add_system_programs(policy);
    const fs::path programs = os::program_folder();
    policy.run.push_back(programs);
    policy.run.push_back(programs.parent_path() / "libexec");
    std::error_code ignored;
    policy.changed.push_back(fs::temp_directory_path(ignored));  // long texts are kept there meanwhile
    return restrict_access(std::move(policy));
}

void add_confine_option(CommandLine& line, bool& no_confine) {
    line.add("--no-confine", &no_confine,
             "do not confine the program before it reads its input; confinement blocks files outside the "
             "folders of its outputs, other programs and the network (Linux, landlock)");
}

}  // namespace gsim::apps
