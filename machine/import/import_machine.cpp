#include "machine/import/import_machine.h"

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/text/printable.h"
#include "base/toml/toml_writer.h"
#include "machine/data/machine_data_document.h"
#include "machine/file/machine_file.h"
#include "machine/import/grbl_dump.h"
#include "machine/import/linuxcnc_ini.h"

namespace gsim::import {

namespace {

bool is_ini(const std::filesystem::path& path) {
    return text::lower(path.extension().string()) == ".ini";
}

// Returns a remark that its content cannot terminate.
std::string remark(std::string_view text) {
    std::string line = "# ";
    for (const char c : text) line += text::is_printable({&c, 1}) ? c : ' ';
    return line + '\n';
}

}  // namespace

bool is_controller_file(std::string_view text, const std::filesystem::path& path) {
    if (is_ini(path)) return true;
    return text::lower(path.extension().string()) != ".toml" && is_grbl_dump(text);
}

Result<ImportResult> import_machine(std::string_view text, const std::filesystem::path& path,
                                    const os::Files& files) {
    auto imported = is_ini(path) ? import_linuxcnc(text, path, files) : import_grbl(text, path.string());
    if (!imported) return imported;
    // A planner cannot use values that a machine file may not contain.
    if (const auto toml = machine_toml(*imported, path); !toml) return tl::unexpected(toml.error());
    return imported;
}

Result<std::string> machine_toml(const ImportResult& imported, const std::filesystem::path& path) {
    std::string toml = remark(fmt::format("Made from {}.", path.filename().string()));
    if (!imported.warnings.empty()) toml += "#\n";
    for (const std::string& warning : imported.warnings) toml += remark(warning);
    if (!imported.left_out.empty()) toml += "#\n# Not imported:\n";
    for (const std::string& name : imported.left_out) toml += remark("  " + name);
    toml += '\n' + machine::print_machine(imported.machine);
    constexpr std::string_view kName = "machine";
    const auto machine = machine::read_machine(toml, kName);
    if (machine) return toml;
    // Its line numbers refer to a file that no user has seen.
    const std::string message = machine.error().message.substr(machine.error().message.find(": ") + 2);
    return Unexpected(
        fmt::format("{}: its settings do not make a valid machine: {}", path.string(), message));
}

Result<std::string> machine_data_text(const ImportResult& imported) {
    machine::MachineDataDocument document(imported.machine.axes);
    return document.update(imported.data).map([&] { return document.text(); });
}

}  // namespace gsim::import
