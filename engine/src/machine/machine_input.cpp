#include "engine/src/machine/machine_input.h"

#include <fmt/format.h>

#include "base/os/files.h"
#include "engine/src/host_names.h"
#include "engine/src/run/process_words.h"
#include "machine/file/machine_file.h"
#include "machine/import/import_machine.h"

namespace gsim::engine {

namespace {

MachineInput from_controller_settings(import::ImportResult imported, const std::string& file) {
    MachineInput input;
    input.machine = std::move(imported.machine);
    if (imported.has_data) input.data = std::move(imported.data);
    input.notes = std::move(imported.warnings);
    if (!imported.left_out.empty()) {
        input.notes.push_back(
            fmt::format("{}: lines that are not imported: {}; gsim-data import {} lists them", file,
                        imported.left_out.size(), file));
    }
    return input;
}

// The words that switch the process of a machine must be those of a dialect.
Result<MachineInput> read_machine_file(const std::string& text, const std::string& file,
                                       const os::Files& files, std::vector<std::string>* errors) {
    machine::FileMessages messages;
    auto machine = machine::read_machine(text, file, files, &messages);
    if (errors != nullptr) *errors = std::move(messages.errors);
    if (!machine) return tl::unexpected(machine.error());
    if (machine->process) {
        if (const auto error = find_process_error(*machine->process))
            return Unexpected(fmt::format("{}: {}", file, error->message));
    }
    return MachineInput{*std::move(machine), {}, {}, std::move(messages.warnings)};
}

Result<MachineInput> read_input(const Host& host, const std::string& name, os::NameSource name_source,
                                std::vector<std::string>* errors) {
    if (name.empty()) {
        return machine::read_machine(machine::built_in_machine_toml(), "built-in machine")
            .map([](machine::Machine machine) {
                return MachineInput{std::move(machine), {}, {}, {}};
            });
    }
    const auto file = resolve_name(host, NameKind::machine, name);
    if (!file) return tl::unexpected(file.error());
    const auto text = host.files.impl().read_text(*file, name_source);  // once: it may be a pipe
    if (!text) return tl::unexpected(text.error());
    if (!import::is_controller_file(*text, *file))
        return read_machine_file(*text, *file, host.files.impl(), errors);
    return import::import_machine(*text, *file, host.files.impl()).map([&](import::ImportResult imported) {
        return from_controller_settings(std::move(imported), *file);
    });
}

}  // namespace

std::vector<text::Diagnostic> machine_diagnostics(const MachineInput& input) {
    std::vector<text::Diagnostic> diagnostics;
    for (const std::string& warning : input.warnings) {
        diagnostics.push_back(text::to_diagnostic(text::DiagnosticKind::machine, warning));
        diagnostics.back().severity = text::Severity::warning;
    }
    for (const std::string& note : input.notes)
        diagnostics.push_back(
            {.severity = text::Severity::note, .kind = text::DiagnosticKind::machine, .text = note});
    return diagnostics;
}

Result<MachineInput> read_machine_input(const Host& host, const std::string& name, os::NameSource name_source,
                                        std::vector<std::string>* errors) {
    auto input = read_input(host, name, name_source, errors);
    if (!input && errors != nullptr && errors->empty()) errors->push_back(input.error().message);
    return input;
}

Result<machine::ProgramTable> read_program_input(const Host& host, const std::string& name) {
    const auto file = resolve_name(host, NameKind::machine, name);
    if (!file) return tl::unexpected(file.error());
    const auto text = host.files.impl().read_text(*file, os::NameSource::command_line);
    if (!text) return tl::unexpected(text.error());
    if (!import::is_controller_file(*text, *file)) return machine::read_program_table(*text, *file);
    return import::import_machine(*text, *file, host.files.impl())
        .map([](const import::ImportResult& imported) { return imported.machine.program; });
}

}  // namespace gsim::engine
