#include "engine/control_settings.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/units.h"
#include "engine/src/guarded.h"
#include "engine/src/machine/machine_parts.h"
#include "engine/src/values.h"
#include "machine/import/import_machine.h"
#include "machine/import/linuxcnc_tables.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

using TakenOver = tl::expected<import::Imported, std::string>;

constexpr const char* kToolTable = ".tbl";
constexpr const char* kParameterTable = ".var";

std::string lower_ending(const std::string& name) {
    return text::lower(std::filesystem::path(name).extension().string());
}

// Returns X, Y and Z, which need only letters here.
std::vector<machine::Axis> plain_axes() {
    std::vector<machine::Axis> axes;
    for (const char letter : {'X', 'Y', 'Z'}) axes.push_back({.letter = letter});
    return axes;
}

TakenOver read_table(std::string_view text, const std::string& name,
                     const ControlSettings::TableChoice& choice) {
    import::Imported imported;
    imported.has_data = true;
    imported.machine.axes =
        choice.machine == nullptr ? plain_axes() : choice.machine->parts().input.machine.axes;
    std::string letters;
    for (const machine::Axis& axis : imported.machine.axes) letters += axis.letter;
    import::TableNotes notes;
    const auto take = lower_ending(name) == kToolTable ? import::take_tools : import::take_parameters;
    const double unit_mm = choice.unit == LengthUnit::inch ? kMmPerInch : 1;
    if (auto taken = take(text, name, unit_mm, letters, imported.data, notes); !taken)
        return tl::unexpected(taken.error());
    imported.left_out = std::move(notes.left_out);
    return imported;
}

std::vector<Diagnostic> left_out_of(const import::Imported& imported, const std::string& name) {
    std::vector<Diagnostic> told;
    const auto add = [&](Severity severity, std::string sentence) {
        told.push_back({.severity = severity,
                        .code = std::string(text::code_of(DiagnosticKind::machine)),
                        .file = name,
                        .text = std::move(sentence)});
    };
    for (const std::string& warning : imported.warnings) add(Severity::warning, warning);
    for (const std::string& entry : imported.left_out) add(Severity::note, "not taken over: " + entry);
    return told;
}

}  // namespace

struct ControlSettings::State {
    import::Imported imported;
    std::string machine_file;
    std::vector<Diagnostic> left_out;
};

bool ControlSettings::is_table(const std::string& name) {
    const std::string ending = lower_ending(name);
    return ending == kToolTable || ending == kParameterTable;
}

tl::expected<ControlSettings, Failure> ControlSettings::read(std::string_view text, const std::string& name,
                                                             const Files& files, const TableChoice& choice) {
    return guarded([&]() -> tl::expected<ControlSettings, Failure> {
        const auto refused = [](std::string sentence) {
            return tl::unexpected(failure_of(DiagnosticKind::input_file, std::move(sentence)));
        };
        if (!is_table(name) && !import::is_control_file(text, name)) {
            return refused(
                fmt::format("'{}' is no LinuxCNC .ini, .tbl or .var, and has no lines as grbl "
                            "answers to $$ ($110=500.000)",
                            name));
        }
        auto imported = is_table(name) ? read_table(text, name, choice)
                                       : import::import_machine(text, name, files.inner());
        if (!imported) return refused(imported.error());
        tl::expected<std::string, std::string> machine_file;
        if (!is_table(name)) machine_file = import::machine_toml(*imported, name);
        if (!machine_file) return refused(machine_file.error());
        auto left_out = left_out_of(*imported, name);
        return ControlSettings(std::make_unique<State>(
            State{*std::move(imported), *std::move(machine_file), std::move(left_out)}));
    });
}

ControlSettings::ControlSettings(std::unique_ptr<State> state) : state_(std::move(state)) {}
ControlSettings::ControlSettings(ControlSettings&&) noexcept = default;
ControlSettings& ControlSettings::operator=(ControlSettings&&) noexcept = default;
ControlSettings::~ControlSettings() = default;

const std::vector<Diagnostic>& ControlSettings::left_out() const {
    return state_->left_out;
}

const std::string& ControlSettings::machine_file() const {
    return state_->machine_file;
}

bool ControlSettings::has_machine_data() const {
    return state_->imported.has_data;
}

tl::expected<std::string, Failure> ControlSettings::machine_data() const {
    return guarded([this] {
        return import::machine_data_text(state_->imported).map_error([](const std::string& sentence) {
            return failure_of(DiagnosticKind::input_file, sentence);
        });
    });
}

}  // namespace gsim::engine
