#pragma once

#include <filesystem>
#include <string>

namespace gsim::batch {

/// Returns the file of the running program, which starts workers and tasks.
inline std::string current_executable() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

}  // namespace gsim::batch
