#include "engine/system/installed_files.h"

#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "base/os/installation.h"
#include "base/text/format.h"
#include "base/text/nearest_name.h"

namespace gsim::engine {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMachineExtension = ".toml";

// A path that cannot be checked counts as existing: opening it reports the reason.
bool file_exists(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error) || error;
}

bool has_folder(const std::string& name) {
    return name.find('/') != std::string::npos;
}

// Returns all paths where an installation may have it.
std::vector<fs::path> candidate_paths(const fs::path& bin_folder, NameKind kind, const std::string& name) {
    std::vector<fs::path> found;
    if (fs::path(name).is_absolute()) return found;
    if (kind == NameKind::module) {
        if (has_folder(name)) return found;
        for (const fs::path& folder : os::module_folders(bin_folder)) {
            found.push_back(folder / name);
            found.push_back(folder / fmt::format("lib{}.so", name));
        }
        return found;
    }
    for (const fs::path& folder : os::data_folders(bin_folder)) {
        if (has_folder(name) || kind == NameKind::library) found.push_back(folder / name);
        // A name with its extension means a file of the user.
        if (kind == NameKind::machine && !has_folder(name) && !fs::path(name).has_extension())
            found.push_back(folder / "samples" / "machines" / (name + std::string(kMachineExtension)));
    }
    return found;
}

// Returns the names of sample machines.
std::vector<std::string> machine_names(const fs::path& bin_folder) {
    std::vector<std::string> names;
    for (const fs::path& folder : os::data_folders(bin_folder)) {
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(folder / "samples" / "machines", ignored))
            names.push_back(entry.path().stem().string());
    }
    return names;
}

std::string suggest_machine(const fs::path& bin_folder, const std::string& name) {
    const std::vector<std::string> names = machine_names(bin_folder);
    const std::vector<std::string_view> known(names.begin(), names.end());
    const auto nearest = text::nearest_name(fs::path(name).stem().string(), known);
    return nearest ? fmt::format("; did you mean '{}'?", *nearest) : std::string();
}

}  // namespace

Result<std::string> find_file_from(const fs::path& bin_folder, NameKind kind, const std::string& name) {
    if (name.empty() || name == "-" || file_exists(name)) return name;
    const std::vector<fs::path> searched_paths = candidate_paths(bin_folder, kind, name);
    for (const fs::path& resolved_path : searched_paths) {
        if (file_exists(resolved_path)) return resolved_path.string();
    }
    std::string message = fmt::format("cannot read '{}': No such file or directory", name);
    std::vector<std::string> searched_names;
    searched_names.reserve(searched_paths.size());
    for (const fs::path& resolved_path : searched_paths)
        searched_names.push_back(fmt::format("'{}'", resolved_path.string()));
    if (!searched_names.empty())
        message += fmt::format(", nor does {} exist", text::joined(searched_names, " or "));
    if (kind == NameKind::machine) message += suggest_machine(bin_folder, name);
    return tl::unexpected(message);
}

Result<std::string> find_file(NameKind kind, const std::string& name) {
    return find_file_from(os::program_folder(), kind, name);
}

}  // namespace gsim::engine
