#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace gsim::tests {

/// Returns the machine file of this name in the first folder that has it; in the last folder if none has it.
inline std::filesystem::path machine_file_in(std::span<const std::string> folders,
                                             const std::string& file_name) {
    std::filesystem::path path;
    for (const std::string& folder : folders) {
        path = std::filesystem::path(folder) / file_name;
        if (std::filesystem::exists(path)) break;
    }
    return path;
}

}  // namespace gsim::tests
