#include "apps/studio/served_names.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "base/os/bound_name.h"
#include "base/os/installation.h"
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

tl::expected<std::string, std::string> served_name(const fs::path& folder, NameKind kind,
                                                   const std::string& file) {
    const auto found = engine::find_file(kind, file);
    if (!found) return tl::unexpected(found.error());
    std::error_code error;
    const fs::path there = fs::canonical(*found, error);
    if (error) return tl::unexpected(fmt::format("cannot read '{}': {}", *found, error.message()));
    const auto below = [&there](const fs::path& above) {
        std::error_code ignored;
        const std::string name = there.lexically_relative(fs::canonical(above, ignored)).generic_string();
        return os::parts_of_bound_name(name) ? name : std::string();
    };
    if (const std::string name = below(folder); !name.empty()) return name;
    for (const fs::path& data : os::data_folders(os::program_folder())) {
        if (const std::string name = below(data / "samples"); !name.empty()) return "samples/" + name;
    }
    return tl::unexpected(
        fmt::format("'{}' lies outside of '{}', the folder that is served; name a folder that "
                    "has both",
                    file, folder.string()));
}

tl::expected<std::string, std::string> served_module(const std::string& name) {
    return engine::find_file(NameKind::module, name).map([](const std::string& file) {
        return fs::absolute(file).string();
    });
}

}  // namespace gsim::apps
