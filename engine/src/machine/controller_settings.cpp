#include "engine/controller_settings.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/units.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/machine/machine_parts.h"
#include "machine/import/import_machine.h"
#include "machine/import/linuxcnc_tables.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

using ExpectedImport = Result<import::ImportResult>;

constexpr const char* kToolTableExtension = ".tbl";
constexpr const char* kParameterTableExtension = ".var";

std::string lower_extension(const std::string& name) {
    return text::lower(std::filesystem::path(name).extension().string());
}

// Returns X, Y and Z, which need only letters here.
std::vector<machine::Axis> make_xyz_axes() {
    std::vector<machine::Axis> axes;
    for (const char letter : {'X', 'Y', 'Z'}) axes.push_back({.letter = letter});
    return axes;
}

ExpectedImport read_table(std::string_view text, const std::string& name,
                          const ControllerSettings::TableOptions& options) {
    import::ImportResult imported;
    imported.has_data = true;
    imported.machine.axes =
        options.machine == nullptr ? make_xyz_axes() : options.machine->parts().input.machine.axes;
    std::string letters;
    for (const machine::Axis& axis : imported.machine.axes) letters += axis.letter;
    import::ImportNotes notes;
    const auto importer =
        lower_extension(name) == kToolTableExtension ? import::import_tools : import::import_parameters;
    const double unit_mm = options.unit == LengthUnit::inch ? kMmPerInch : 1;
    if (auto result = importer(text, name, unit_mm, letters, imported.data, notes); !result)
        return tl::unexpected(result.error());
    imported.left_out = std::move(notes.left_out);
    return imported;
}

std::vector<Diagnostic> left_out_diagnostics(const import::ImportResult& imported, const std::string& name) {
    std::vector<Diagnostic> diagnostics;
    const auto add = [&](Severity severity, std::string message) {
        diagnostics.push_back({.severity = severity,
                               .code = std::string(text::diagnostic_code(DiagnosticKind::machine)),
                               .file = name,
                               .text = std::move(message)});
    };
    for (const std::string& warning : imported.warnings) add(Severity::warning, warning);
    for (const std::string& entry : imported.left_out) add(Severity::note, "not imported: " + entry);
    return diagnostics;
}

}  // namespace

struct ControllerSettings::State {
    import::ImportResult imported;
    std::string machine_file;
    std::vector<Diagnostic> left_out;
};

bool ControllerSettings::is_table(const std::string& name) {
    const std::string extension = lower_extension(name);
    return extension == kToolTableExtension || extension == kParameterTableExtension;
}

tl::expected<ControllerSettings, Error> ControllerSettings::read(std::string_view text,
                                                                 const std::string& name, const Files& files,
                                                                 const TableOptions& options) {
    return guard_exceptions([&]() -> tl::expected<ControllerSettings, Error> {
        const auto unexpected_error = [](std::string message) {
            return tl::unexpected(make_error(DiagnosticKind::input_file, std::move(message)));
        };
        if (!is_table(name) && !import::is_controller_file(text, name)) {
            return unexpected_error(
                fmt::format("'{}' is not a LinuxCNC .ini, .tbl or .var, and has no lines of grbl's response "
                            "to $$ ($110=500.000)",
                            name));
        }
        auto imported = is_table(name) ? read_table(text, name, options)
                                       : import::import_machine(text, name, files.impl());
        if (!imported) return unexpected_error(imported.error().message);
        Result<std::string> machine_file;
        if (!is_table(name)) machine_file = import::machine_toml(*imported, name);
        if (!machine_file) return unexpected_error(machine_file.error().message);
        auto left_out = left_out_diagnostics(*imported, name);
        return ControllerSettings(std::make_unique<State>(
            State{*std::move(imported), *std::move(machine_file), std::move(left_out)}));
    });
}

ControllerSettings::ControllerSettings(std::unique_ptr<State> state) : state_(std::move(state)) {}
ControllerSettings::ControllerSettings(ControllerSettings&&) noexcept = default;
ControllerSettings& ControllerSettings::operator=(ControllerSettings&&) noexcept = default;
ControllerSettings::~ControllerSettings() = default;

const std::vector<Diagnostic>& ControllerSettings::left_out() const {
    return state_->left_out;
}

const std::string& ControllerSettings::machine_file() const {
    return state_->machine_file;
}

bool ControllerSettings::has_machine_data() const {
    return state_->imported.has_data;
}

tl::expected<std::string, Error> ControllerSettings::machine_data() const {
    return guard_exceptions([this] {
        return import::machine_data_text(state_->imported).map_error([](const gsim::Error& error) {
            return make_error(DiagnosticKind::input_file, error.message);
        });
    });
}

}  // namespace gsim::engine
