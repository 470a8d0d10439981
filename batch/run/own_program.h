#pragma once

#include <filesystem>
#include <string>

namespace gsim::batch {

/// The file of the program that runs: workers and tasks are begun by it.
inline std::string own_program() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

}  // namespace gsim::batch
