#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/files.h"
#include "cam/waterjet/materials.h"

namespace gsim::waterjet {

/// Reads a materials file (docs/waterjet.md) strictly: anything unknown, unclear or unusable is an error,
/// "file:line:column: message". `file_name` is only for that.
Result<Materials> read_materials(std::string_view toml_text, std::string_view file_name);

/// Reads a file with read_materials().
Result<Materials> load_materials(const std::filesystem::path& path,
                                 os::NameSource name_source = os::NameSource::in_file,
                                 const os::Files& files = os::disk());

/// Returns the text of samples/materials.toml, which is compiled in.
std::string_view built_in_materials_toml();

}  // namespace gsim::waterjet
