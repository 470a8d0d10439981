#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/files.h"
#include "controller/services/controller_rules.h"

namespace gsim::base {
class TomlSection;
class TomlText;
}  // namespace gsim::base

namespace gsim::machine {

/// Reads a controller file (docs/machine-file.md) as strictly as machine files are read. The error is
/// "file:line:column: sentence"; `file_name` is only for that. `model` is the name of the rules where the
/// file gives them none.
tl::expected<rrs::ControllerRules, std::string> read_controller(std::string_view toml_text,
                                                                std::string_view file_name,
                                                                std::string model);

/// Names of the controllers that are compiled in, those of samples/controllers.
std::vector<std::string_view> built_in_controllers();

/// The text of one of them; data() is null if there is none of that name.
std::string_view built_in_controller_toml(std::string_view model);

/// The rules of one of them; nothing if there is none of that name.
std::optional<rrs::ControllerRules> built_in_controller(std::string_view model);

/// The rules of a machine file's table [controller]. `folder` is where the machine file lies; a controller
/// file of one's own is looked for from there.
rrs::ControllerRules read_controller_section(base::TomlSection& section, const std::filesystem::path& folder,
                                             const os::Files& files);

/// Writes a table [controller] that stands for itself: it gives equal rules wherever it is read. Nothing
/// where the rules are those of a machine without such a table.
void print_controller(base::TomlText& out, const rrs::ControllerRules& rules);

}  // namespace gsim::machine
