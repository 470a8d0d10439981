#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::os {

/// The folder of the program that runs, wherever links to it are; empty where the system does not tell.
std::filesystem::path program_folder();

/// Where an installation with the program `bin_folder`/gsim keeps what programs read (samples, the library in
/// Lua), relative to the program: an installation may be moved, and a build folder looks like one.
std::vector<std::filesystem::path> data_folders(const std::filesystem::path& bin_folder);

/// A program that others call (gsim-serve): beside the program that runs, as in a build folder, or where an
/// installation keeps it. The error is a sentence that says where it was looked for.
tl::expected<std::filesystem::path, std::string> helper_program(const std::filesystem::path& bin_folder,
                                                                const std::string& name);

/// Where it keeps controller modules.
std::vector<std::filesystem::path> module_folders(const std::filesystem::path& bin_folder);

}  // namespace gsim::os
