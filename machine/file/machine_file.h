#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/os/files.h"
#include "machine/file/file_messages.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Reads a machine file (docs/machine-file.md) strictly: unknown or invalid content is an error. The error is
/// "file:line:column: message". `file_name` is for that, and for a custom controller file and the meshes of
/// shapes, which are searched in the folder of the machine file. Meshes are only checked for existence; they
/// are not read. `files` has them. `messages`, if given, receives all errors and warnings.
Result<Machine> read_machine(std::string_view toml_text, std::string_view file_name,
                             const os::Files& files = os::disk(), FileMessages* messages = nullptr);

/// Runs read_machine() on a file.
Result<Machine> load_machine(const std::filesystem::path& path,
                             os::NameSource name_source = os::NameSource::in_file,
                             const os::Files& files = os::disk(), FileMessages* messages = nullptr);

/// Returns a machine file that read_machine() reads back as an equal machine, if it accepts this one at all.
/// Meshes have their full path in it, so that it may be in any folder.
std::string print_machine(const Machine& machine);

/// Returns the text of samples/machines/af5.toml, the machine of Table C.1 of the thesis, which is compiled
/// in.
std::string_view built_in_machine_toml();

}  // namespace gsim::machine
