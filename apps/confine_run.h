#pragma once

#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "apps/run_arguments.h"
#include "base/os/confinement.h"
#include "cli/command_line.h"

namespace gsim::apps {

/// What a run may still need of the file system once its machine and its cell have been read: the folders of
/// its programs, where the ones that they call are looked up, those of its outputs, and further files that
/// its request names; for a picture the programs of the system, gnuplot among them.
os::Allowed allowed_to(const RunArguments& arguments, const engine::Request& request,
                       std::span<const std::string> programs);

/// Confines the process to that, unless the options say otherwise or name a controller module, whose code
/// may reach what it likes. `request` has the files that its names mean. The error is a sentence.
tl::expected<void, std::string> confine_run(const RunArguments& arguments, const engine::Request& request,
                                            std::span<const std::string> programs);

/// Confines the process to these files, which may be read, and to the folders of `outputs`. For programs that
/// have read all else that their options name. The error is a sentence.
tl::expected<void, std::string> confine_to(std::span<const std::string> files,
                                           std::span<const std::string> outputs);

/// Confines the process to files of these folders, which may be read, and to the programs of the system and
/// our own (gsim-solid). The error is a sentence.
tl::expected<void, std::string> confine_to_folders(std::span<const std::filesystem::path> folders);

/// --no-confine of such programs; in the group begun last.
void add_confine_option(CommandLine& line, bool& no_confine);

}  // namespace gsim::apps
