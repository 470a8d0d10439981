#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::conformance {

/// Part program with its canonical output recorded in the same folder.
struct Recorded {
    std::filesystem::path program;
    std::filesystem::path canon;      ///< Compressed by gzip.
    bool without_kinematics = false;  ///< Recorded after the words M428, M429 and M430 were deleted.
};

/// The recorded programs below a folder, sorted by name: FILE with FILE.canon.gz or
/// FILE.canon-without-M428-430.gz. The error names the folder that cannot be read.
Result<std::vector<Recorded>> find_recorded(const std::filesystem::path& folder);

/// A program's text without the words M428, M429 and M430.
std::string without_kinematics_switches(const std::string& program);

}  // namespace gsim::conformance
