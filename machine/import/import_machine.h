#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/os/files.h"
#include "machine/import/imported.h"

namespace gsim::import {

/// Whether a machine file is the settings of a control: its name ends in .ini (LinuxCNC), or it has lines as
/// grbl answers `$$` with.
bool is_control_file(std::string_view text, const std::filesystem::path& path);

/// Reads the settings of a control, with the files of offsets and tools that they name, which are looked for
/// in the folder of `path`. The error is a sentence with its place; settings that no machine file can hold
/// are one, too.
tl::expected<Imported, std::string> import_machine(std::string_view text, const std::filesystem::path& path,
                                                   const os::Files& files = os::disk());

/// A machine file of it, which says in remarks where it is from and what is not taken over. The error is a
/// sentence: values that no machine file can hold.
tl::expected<std::string, std::string> machine_toml(const Imported& imported,
                                                    const std::filesystem::path& path);

/// Its offsets, tools and variables as machine data (NCFILE). The error is a sentence.
tl::expected<std::string, std::string> machine_data_text(const Imported& imported);

}  // namespace gsim::import
