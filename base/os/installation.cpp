#include "base/os/installation.h"

#include <system_error>

#include <fmt/format.h>

namespace gsim::os {

namespace fs = std::filesystem;

fs::path program_folder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::path() : program.parent_path();
}

std::vector<fs::path> data_folders(const fs::path& bin_folder) {
    if (bin_folder.empty()) return {};
    return {bin_folder.parent_path() / GSIM_DATA_FOLDER};
}

Result<fs::path> helper_program(const fs::path& bin_folder, const std::string& name) {
    const fs::path installed = bin_folder.parent_path() / "libexec" / "gsim";
    for (const fs::path& folder : {bin_folder, installed}) {
        std::error_code error;
        if (fs::exists(folder / name, error)) return folder / name;
    }
    return Unexpected(fmt::format("the program {} is neither in '{}' nor in '{}'", name, bin_folder.string(),
                                  installed.string()));
}

std::vector<fs::path> module_folders(const fs::path& bin_folder) {
    if (bin_folder.empty()) return {};
    return {bin_folder.parent_path() / GSIM_MODULE_FOLDER, bin_folder.parent_path() / "lib"};
}

}  // namespace gsim::os
