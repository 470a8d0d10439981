#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gsim::accuracy {

/// Returns the machine file of this name in the first folder that has it; in the last folder if none has it.
std::filesystem::path machine_file_in(std::span<const std::string> folders, const std::string& file_name);

}  // namespace gsim::accuracy
