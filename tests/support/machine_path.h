#pragma once

#include <filesystem>
#include <string>

#include "tests/build_files/build_files.h"

namespace gsim::tests {

/// Returns the path of a machine file: a sample, or else one of the machines that controllers were recorded
/// on.
inline std::string machine_path(const std::string& file_name) {
    const std::string sample = source_path("samples/machines/" + file_name);
    return std::filesystem::exists(sample) ? sample : source_path("tests/accuracy/machines/" + file_name);
}

}  // namespace gsim::tests
