#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/files.h"
#include "machine/import/import_result.h"

namespace gsim::import {

/// Reads the INI file of a LinuxCNC machine with trivial kinematics (trivkins): axes, joints, limits, units,
/// homes, the parameters of its planner. It also reads the files of parameters and tools that it names, which
/// are searched in its folder. The error is "file:line: message".
Result<ImportResult> import_linuxcnc(std::string_view text, const std::filesystem::path& path,
                                     const os::Files& files = os::disk());

}  // namespace gsim::import
