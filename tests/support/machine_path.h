#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/build_files/build_files.h"
#include "tests/support/machine_folders.h"

namespace gsim::tests {

/// Returns the folders of machine files: samples, and machines that controllers were recorded on.
inline std::array<std::string, 2> machine_folders() {
    return {source_path("samples/machines"), source_path("tests/accuracy/machines")};
}

/// Returns the path of a machine file in the first of these folders that has it.
inline std::filesystem::path machine_path(const std::string& file_name) {
    return machine_file_in(machine_folders(), file_name);
}

/// Returns all files of these folders, by their names.
inline std::vector<std::filesystem::path> machine_files() {
    std::vector<std::filesystem::path> files;
    for (const std::string& folder : machine_folders())
        for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end(),
              [](const auto& a, const auto& b) { return a.filename() < b.filename(); });
    return files;
}

}  // namespace gsim::tests
