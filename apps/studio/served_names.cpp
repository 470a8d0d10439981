#include "apps/studio/served_names.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "base/os/installation.h"
#include "base/os/safe_name.h"
#include "engine/system/installed_files.h"

namespace gsim::apps {

namespace fs = std::filesystem;
using engine::NameKind;

fs::path served_folder(const std::string& folder, const std::string& program) {
    if (!folder.empty()) return folder;
    const fs::path file = fs::path(program);
    std::error_code ignored;
    if (!program.empty() && fs::exists(file, ignored)) return fs::absolute(file).parent_path();
    return fs::current_path();
}

Result<std::string> served_name(const fs::path& folder, NameKind kind, const std::string& file) {
    const auto found = engine::find_file(kind, file);
    if (!found) return tl::unexpected(found.error());
    std::error_code error;
    const fs::path canonical_path = fs::canonical(*found, error);
    if (error) return Unexpected(fmt::format("cannot read '{}': {}", *found, error.message()));
    const auto is_below = [&canonical_path](const fs::path& parent_folder) {
        std::error_code ignored;
        const std::string name =
            canonical_path.lexically_relative(fs::canonical(parent_folder, ignored)).generic_string();
        return os::safe_name_parts(name) ? name : std::string();
    };
    if (const std::string name = is_below(folder); !name.empty()) return name;
    for (const fs::path& data : os::data_folders(os::program_folder())) {
        if (const std::string name = is_below(data / "samples"); !name.empty()) return "samples/" + name;
    }
    return Unexpected(fmt::format("'{}' is outside the served folder '{}'; name a folder that contains both",
                                  file, folder.string()));
}

Result<std::string> served_module(const std::string& name) {
    return engine::find_file(NameKind::module, name).map([](const std::string& file) {
        return fs::absolute(file).string();
    });
}

}  // namespace gsim::apps
