#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

namespace gsim::apps {

/// What a name on the command line stands for, where there is no file of that name.
enum class InstalledKind {
    sample,   ///< Any file below the installed folder: "samples/wheel.nc".
    machine,  ///< That, or the name of a sample machine: "router3".
    library,  ///< The library in Lua: "lua_lib".
    module,   ///< A controller module by its name: "gsim_rcs_default".
};

/// The file that a name on the command line means. A file of that name goes before all else, and `-` and an
/// empty name stay as they are. Else it is looked for where the program that runs was installed. Where it is
/// not there either, the error is a sentence that says where it was looked for.
tl::expected<std::string, std::string> find_file(InstalledKind kind, const std::string& name);

/// find_file() with the program in `bin_folder`.
tl::expected<std::string, std::string> find_file_from(const std::filesystem::path& bin_folder,
                                                      InstalledKind kind, const std::string& name);

/// A post as path2gcode takes it: one that is built in by its name, which stays, or a file.
tl::expected<std::string, std::string> find_post_file(const std::string& name);

}  // namespace gsim::apps
