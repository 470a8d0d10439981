#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/os/files.h"
#include "controller/services/controller_rules.h"
#include "machine/file/file_messages.h"

namespace gsim::base {
class TomlSection;
class TomlWriter;
}  // namespace gsim::base

namespace gsim::machine {

/// Reads a controller file (docs/machine-file.md) as strictly as machine files. The error is
/// "file:line:column: message"; `file_name` is only for that. `model` is the name of the rules if the file
/// gives none. `messages`, if given, receives all errors and warnings.
Result<rrs::ControllerRules> read_controller(std::string_view toml_text, std::string_view file_name,
                                             std::string model, FileMessages* messages = nullptr);

/// Returns the names of the controllers that are compiled in, those of samples/controllers.
std::vector<std::string_view> built_in_controllers();

/// Returns the text of one of them; data() is null if the name is unknown.
std::string_view built_in_controller_toml(std::string_view model);

/// Returns the rules of one of them; nothing if the name is unknown.
std::optional<rrs::ControllerRules> built_in_controller(std::string_view model);

/// Returns the rules of a machine file's table [controller]. `folder` is that of the machine file; a custom
/// controller file is searched from there.
rrs::ControllerRules read_controller_section(base::TomlSection& section, const std::filesystem::path& folder,
                                             const os::Files& files);

/// Writes a self-contained table [controller]: it gives equal rules wherever it is read. Writes nothing if
/// the rules are those of a machine without such a table.
void print_controller(base::TomlWriter& out, const rrs::ControllerRules& rules);

}  // namespace gsim::machine
