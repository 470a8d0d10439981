#pragma once

#include <filesystem>
#include <vector>

namespace gsim::os {

/// The folder of the program that runs, wherever links to it are; empty where the system does not tell.
std::filesystem::path program_folder();

/// Where an installation with the program `bin_folder`/gsim keeps what programs read (samples, the library in
/// Lua), relative to the program: an installation may be moved, and a build folder looks like one.
std::vector<std::filesystem::path> data_folders(const std::filesystem::path& bin_folder);

/// Where it keeps controller modules.
std::vector<std::filesystem::path> module_folders(const std::filesystem::path& bin_folder);

}  // namespace gsim::os
