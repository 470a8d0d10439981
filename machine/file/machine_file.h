#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/files.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Reads a machine file (docs/machine-file.md) strictly: what it does not know or does not understand is an
/// error. The error is "file:line:column: sentence". `file_name` is for that, and for a controller file of
/// one's own and the meshes of shapes, which are looked for in the folder of the machine file. Of meshes it
/// is told whether they are there; they are not read. `files` has them. `faults`, where given, gets all that
/// is wrong, each as an error and the first one first.
tl::expected<Machine, std::string> read_machine(std::string_view toml_text, std::string_view file_name,
                                                const os::Files& files = os::disk(),
                                                std::vector<std::string>* faults = nullptr);

/// read_machine() of a file.
tl::expected<Machine, std::string> load_machine(const std::filesystem::path& path,
                                                os::NamedBy named_by = os::NamedBy::a_file,
                                                const os::Files& files = os::disk());

/// A machine file that read_machine() reads back as an equal machine, if it accepts this one at all. Meshes
/// have their whole path in it, so that it may lie in any folder.
std::string print_machine(const Machine& machine);

/// The text of samples/machines/af5.toml, the machine of Table C.1 of the thesis, which is compiled in.
std::string_view built_in_machine_toml();

}  // namespace gsim::machine
