#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/files.h"
#include "machine/import/import_result.h"

namespace gsim::import {

/// True if a machine file contains the settings of a controller: its name ends in .ini (LinuxCNC), or it has
/// lines like the response of grbl to `$$`.
bool is_controller_file(std::string_view text, const std::filesystem::path& path);

/// Reads the settings of a controller, with the files of offsets and tools that they name, which are searched
/// in the folder of `path`. The error is a message with its source location. Settings that no machine file
/// can hold are an error, too.
Result<ImportResult> import_machine(std::string_view text, const std::filesystem::path& path,
                                    const os::Files& files = os::disk());

/// Returns a machine file of it. Remarks in it give its source and the settings that are not taken over. The
/// error is a message: values that no machine file can hold.
Result<std::string> machine_toml(const ImportResult& imported, const std::filesystem::path& path);

/// Returns its offsets, tools and variables as machine data (NCFILE).
Result<std::string> machine_data_text(const ImportResult& imported);

}  // namespace gsim::import
