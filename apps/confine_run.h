#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "apps/run_arguments.h"
#include "base/error.h"
#include "base/os/confinement.h"
#include "cli/command_line.h"

namespace gsim::apps {

/// Returns the file system access that a run may still need once its machine and its cell have been read: the
/// folders of its programs, where called programs are searched, those of its outputs, and further files that
/// its request names; for a picture the programs of the system, including gnuplot.
os::SandboxPolicy run_sandbox_policy(const RunArguments& arguments, const engine::Request& request,
                                     std::span<const std::string> programs);

/// Confines the process to that, unless the options say otherwise or name a controller module, because its
/// code may access anything. `request` has the files of its names.
Result<void> confine_run(const RunArguments& arguments, const engine::Request& request,
                         std::span<const std::string> programs);

/// Confines the process to these files, which may be read, and to the folders of `outputs`. For programs that
/// have read all other files of their options.
Result<void> confine_to(std::span<const std::string> files, std::span<const std::string> outputs);

/// Confines the process to files of these folders, which may be read, and to the programs of the system and
/// our own (gsim-solid).
Result<void> confine_to_folders(std::span<const std::filesystem::path> folders);

/// Adds --no-confine for such programs, in the latest group.
void add_confine_option(CommandLine& line, bool& no_confine);

}  // namespace gsim::apps
