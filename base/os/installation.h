#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::os {

/// Returns the folder of the running program, wherever links to it are; empty if the system does not report
/// it.
std::filesystem::path program_folder();

/// Returns the folders in which an installation with the program `bin_folder`/gsim keeps the files that
/// programs read (samples, the library in Lua). They are relative to the program, because an installation may
/// be moved, and a build folder looks like one.
std::vector<std::filesystem::path> data_folders(const std::filesystem::path& bin_folder);

/// Returns a program that others call (gsim-serve): next to the running program, as in a build folder, or
/// where an installation keeps it. The error is a message with the searched positions.
Result<std::filesystem::path> helper_program(const std::filesystem::path& bin_folder,
                                             const std::string& name);

/// Returns its folders of controller modules.
std::vector<std::filesystem::path> module_folders(const std::filesystem::path& bin_folder);

}  // namespace gsim::os
