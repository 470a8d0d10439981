#include "apps/run_inputs.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/data_file.h"
#include "apps/machine_data_file.h"
#include "apps/probe_option.h"
#include "apps/process_words.h"
#include "apps/variables_file.h"
#include "base/os/file_identity.h"
#include "base/os/input_file.h"
#include "runtime/cell/cell_file.h"
#include "runtime/rcs/rcs_machine.h"

namespace gsim::apps {

namespace {

tl::expected<machine::MachineDataDocument, std::string> read_data(const RunArguments& arguments,
                                                                  const MachineInput& input) {
    const machine::Machine& machine = input.machine;
    if (arguments.machine_data.empty()) {
        machine::MachineDataDocument document(machine.axes);
        if (!input.data) return document;
        return document.update(*input.data).map([&] { return document; });
    }
    return open_machine_data(arguments.machine_data, machine.axes, arguments.machine_data_named_by)
        .map_error([](const auto& errors) { return errors.front(); });
}

tl::expected<machine::MachineData, std::string> with_variables(const RunArguments& arguments,
                                                               machine::MachineData data) {
    if (arguments.variables.empty()) return data;
    return read_variables(arguments.variables).map([&](const std::map<int, double>& variables) {
        for (const auto& [number, value] : variables) data.variables[number] = value;
        return std::move(data);
    });
}

tl::expected<std::optional<script::Script>, std::string> read_setup(const RunArguments& arguments,
                                                                    const Language& language,
                                                                    const TellDiagnostic& tell) {
    std::optional<script::Script> none;
    if (arguments.setup.empty()) return none;
    return read_script(arguments.setup, language, tell)
        .map([](script::Script script) { return std::optional(std::move(script)); })
        .map_error([](InputError error) { return std::move(error.message); });
}

/// Nothing where no controller module is asked for.
tl::expected<std::optional<rrs::RcsModule>, std::string> load_module(const RunArguments& arguments,
                                                                     const machine::Machine& machine) {
    std::optional<rrs::RcsModule> none;
    if (arguments.rcs.empty()) return none;
    const rcs::RcsMachine described(simulation::planner_setup(machine));
    auto library = rrs::RcsLibrary::load(arguments.rcs, described.get());
    if (!library) return tl::unexpected(std::move(library.error()));
    return rrs::RcsModule::create(*std::move(library), described.get()).map([](rrs::RcsModule module) {
        return std::optional<rrs::RcsModule>(std::move(module));
    });
}

/// An output that is a file which the cell names, as a sentence.
std::optional<std::string> conflict_with_cell(const RunArguments& arguments, const cell::CellFiles& files) {
    std::vector<std::pair<const std::string*, const char*>> written = {{&arguments.findings.sarif, "--sarif"},
                                                                       {&arguments.variables, "--variables"}};
    for (const OutputNames::File& file : OutputNames::files())
        written.emplace_back(&(arguments.outputs.*file.name), file.option);
    for (const auto& [file, what] :
         {std::pair{files.machine, "machine"}, {files.machine_data, "machine data"}}) {
        const auto identity = os::identity_of(file);
        if (file.empty() || !identity) continue;
        for (const auto& [name, option] : written) {
            if (name->empty() || os::identity_of(*name) != identity) continue;
            return fmt::format(
                "{} '{}' is the {} of the cell, which would be overwritten; give it another name", option,
                *name, what);
        }
    }
    return std::nullopt;
}

// What the command line does not say itself.
RunArguments with_files_of_cell(RunArguments arguments, const cell::CellFiles& files) {
    if (arguments.machine.empty()) {
        arguments.machine = files.machine.string();
        arguments.machine_named_by = os::NamedBy::a_file;
    }
    if (arguments.machine_data.empty()) {
        arguments.machine_data = files.machine_data.string();
        arguments.machine_data_named_by = os::NamedBy::a_file;
    }
    return arguments;
}

}  // namespace

tl::expected<RunArguments, std::string> with_files_found(RunArguments arguments) {
    for (const auto& [name, kind] : {std::pair{&arguments.input, InstalledKind::sample},
                                     {&arguments.machine_data, InstalledKind::sample},
                                     {&arguments.cell, InstalledKind::sample},
                                     {&arguments.robots, InstalledKind::sample},
                                     {&arguments.setup, InstalledKind::sample},
                                     {&arguments.overrides.file, InstalledKind::sample},
                                     {&arguments.lua_lib, InstalledKind::library},
                                     {&arguments.rcs, InstalledKind::module}}) {
        auto found = find_file(kind, *name);
        if (!found) return tl::unexpected(found.error());
        *name = *std::move(found);
    }
    if (arguments.cell.empty()) return arguments;
    auto text = os::read_text_file(arguments.cell, os::NamedBy::command_line);
    if (!text) return tl::unexpected(text.error());
    arguments.cell_text = *std::move(text);
    const auto files = cell::read_cell_files(arguments.cell_text, arguments.cell);
    if (!files) return tl::unexpected(files.error());
    if (auto conflict = conflict_with_cell(arguments, *files)) return tl::unexpected(*std::move(conflict));
    return with_files_of_cell(std::move(arguments), *files);
}

tl::expected<MachineInput, std::string> read_machine(const RunArguments& arguments) {
    if (!arguments.studies.check.empty())
        return read_machine_input(arguments.studies.check, os::NamedBy::command_line);
    return read_machine_input(arguments.machine, arguments.machine_named_by);
}

tl::expected<RunInputs, InputError> read_run_inputs(const RunArguments& arguments, MachineInput input,
                                                    OpenedScript& opened, const TellDiagnostic& tell) {
    machine::Machine& machine = input.machine;
    const auto fault = [](std::string message) {
        return tl::unexpected(
            InputError{.message = std::move(message), .kind = text::DiagnosticKind::input_file});
    };
    const auto probe = read_probe_option(arguments.probe, machine);
    if (!probe) return fault(probe.error());
    auto overrides = read_overrides(arguments.overrides, machine.controller);
    if (!overrides) return fault(overrides.error());
    auto document = read_data(arguments, input);
    if (!document) return fault(document.error());
    auto data = with_variables(arguments, document->data());
    if (!data) return fault(data.error());
    auto language = language_of(arguments.language, machine.program, *data);
    if (!language) return fault(language.error());
    language->cpu = arguments.limits.cpu;
    language->memory_bytes = arguments.memory_mb << 20U;
    auto program = read_script(opened, *language, tell);
    if (!program) return tl::unexpected(program.error());
    language->dialect = grammar::dialect_named(program->dialect);
    if (program->inch) language->units = machine::ProgramUnits::inch;
    if (machine.process) {
        if (const auto fault_of_words = fault_of_process(*machine.process, *language->dialect))
            return fault(*fault_of_words);
    }
    auto setup = read_setup(arguments, *language, tell);
    if (!setup) return fault(setup.error());
    auto module = load_module(arguments, machine);
    if (!module) return fault(module.error());
    auto cell = read_run_cell(cell_choice(arguments), machine);
    if (!cell) return fault(cell.error());
    return RunInputs{.machine = std::move(machine),
                     .document = *std::move(document),
                     .data = *std::move(data),
                     .language = *std::move(language),
                     .program = *std::move(program),
                     .setup = *std::move(setup),
                     .module = *std::move(module),
                     .cell = *std::move(cell),
                     .probe = *probe,
                     .overrides = *std::move(overrides)};
}

}  // namespace gsim::apps
