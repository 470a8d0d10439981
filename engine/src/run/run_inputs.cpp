#include "engine/src/run/run_inputs.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "collision/cell/cell_file.h"
#include "engine/src/host_names.h"
#include "engine/src/run/language.h"
#include "engine/src/run/override_changes.h"
#include "engine/src/run/probe_choice.h"
#include "engine/src/run/process_words.h"
#include "engine/src/run/variables_text.h"

namespace gsim::engine {

namespace {

tl::expected<machine::MachineData, std::string> with_variables(const Request& request,
                                                               machine::MachineData data) {
    if (request.variables.empty()) return data;
    return read_variables(request.host.files.inner(), request.variables)
        .map([&](const std::map<int, double>& variables) {
            for (const auto& [number, value] : variables) data.variables[number] = value;
            return std::move(data);
        });
}

// Sets the values that the request itself does not contain.
void take_files_of_cell(FoundRequest& found, const cell::CellFiles& files) {
    Request& request = found.request;
    if (request.machine.empty()) {
        request.machine = files.machine.string();
        found.machine_named_by = os::NamedBy::a_file;
    }
    if (request.machine_data.empty()) {
        request.machine_data = files.machine_data.string();
        found.machine_data_named_by = os::NamedBy::a_file;
    }
}

std::string contradiction_of_robots(const Request& request) {
    for (const auto& [value, option] : {std::pair{&request.machine, "--machine"},
                                        {&request.machine_data, "--machine-data"},
                                        {&request.cell, "--cell"},
                                        {&request.probe, "--probe"},
                                        {&request.module, "--rcs"},
                                        {&request.variables, "--variables"}}) {
        if (!value->empty()) return fmt::format("{} does not go with --robots", option);
    }
    return {};
}

std::string first_override(const OverrideChoice& choice) {
    if (choice.feed_percent) return "--feed-override";
    if (choice.rapid_percent) return "--rapid-override";
    return choice.spindle_percent ? "--spindle-override" : "--overrides";
}

}  // namespace

tl::expected<machine::MachineDataDocument, std::string> read_data_of(const FoundRequest& found,
                                                                     const MachineInput& input) {
    const Request& request = found.request;
    const machine::Machine& machine = input.machine;
    if (request.machine_data.empty()) {
        machine::MachineDataDocument document(machine.axes);
        if (!input.data) return document;
        return document.update(*input.data).map([&] { return document; });
    }
    const auto text = request.host.files.inner().read_text(request.machine_data, found.machine_data_named_by);
    if (!text) return tl::unexpected(text.error());
    return machine::MachineDataDocument::read(*text, request.machine_data, machine.axes)
        .map_error([](const std::vector<std::string>& errors) { return errors.front(); });
}

tl::expected<std::optional<rrs::RcsModule>, std::string> load_module(const Request& request,
                                                                     const machine::Machine& machine) {
    std::optional<rrs::RcsModule> none;
    if (request.module.empty()) return none;
    if (!request.host.load_module)
        return tl::unexpected(fmt::format("{}: controller modules are not loaded here", request.module));
    return request.host.load_module(request.module, machine)
        .map([](const std::shared_ptr<rrs::RcsModule>& module) {
            return std::optional<rrs::RcsModule>(std::move(*module));
        });
}

std::string find_contradiction(const Request& request) {
    if (!request.module.empty() && !request.overrides.turns_nothing()) {
        return fmt::format("{} does not go with --rcs: a module has an override of its own, SetOverrideSpeed",
                           first_override(request.overrides));
    }
    return request.robots.empty() ? std::string() : contradiction_of_robots(request);
}

tl::expected<Request, std::string> with_names_found(Request request) {
    for (const auto& [name, kind] : {std::pair{&request.machine_data, NameKind::sample},
                                     {&request.cell, NameKind::sample},
                                     {&request.robots, NameKind::sample},
                                     {&request.setup, NameKind::sample},
                                     {&request.overrides.file, NameKind::sample},
                                     {&request.library, NameKind::library},
                                     {&request.module, NameKind::module}}) {
        auto file = find_name(request.host, kind, *name);
        if (!file) return tl::unexpected(file.error());
        *name = *std::move(file);
    }
    return request;
}

tl::expected<FoundRequest, std::string> with_files_found(Request request) {
    auto named = with_names_found(std::move(request));
    if (!named) return tl::unexpected(std::move(named.error()));
    FoundRequest found{.request = *std::move(named)};
    if (found.request.cell.empty()) return found;
    const std::string& cell = found.request.cell;
    auto text = found.request.host.files.inner().read_text(cell, os::NamedBy::command_line);
    if (!text) return tl::unexpected(text.error());
    found.cell_text = *std::move(text);
    const auto files = cell::read_cell_files(found.cell_text, cell);
    if (!files) return tl::unexpected(files.error());
    take_files_of_cell(found, *files);
    return found;
}

tl::expected<FoundRequest, std::string> with_machine_files_found(const Request& request) {
    Request of_machine;
    of_machine.machine = request.machine;
    of_machine.machine_data = request.machine_data;
    of_machine.cell = request.cell;
    of_machine.collisions = request.collisions;
    of_machine.host = request.host;
    return with_files_found(std::move(of_machine));
}

CellChoice cell_choice(const FoundRequest& found) {
    return {.file = found.request.cell,
            .text = found.cell_text,
            .collisions = found.request.collisions,
            .files = mesh_files(found.request.host)};
}

tl::expected<std::optional<script::Script>, InputError> read_setup(const Request& request,
                                                                   const Language& language,
                                                                   const TellDiagnostic& tell) {
    std::optional<script::Script> none;
    if (request.setup.empty()) return none;
    return read_script(request.host.files.inner(), request.setup, language, tell)
        .map([](script::Script script) { return std::optional(std::move(script)); });
}

tl::expected<RunInputs, InputError> read_run_inputs(const FoundRequest& found, MachineInput input,
                                                    std::shared_ptr<const cell::Cell> cell_read,
                                                    OpenedScript& opened, const RunTools& tools) {
    const Request& request = found.request;
    machine::Machine& machine = input.machine;
    const auto fault = [](std::string message) {
        return tl::unexpected(
            InputError{.message = std::move(message), .kind = text::DiagnosticKind::input_file});
    };
    const auto probe = read_probe_choice(request.probe, machine);
    if (!probe) return fault(probe.error());
    auto overrides = read_overrides(request.host.files.inner(), request.overrides, machine.controller);
    if (!overrides) return fault(overrides.error());
    auto document = read_data_of(found, input);
    if (!document) return fault(document.error());
    auto data = with_variables(request, document->data());
    if (!data) return fault(data.error());
    auto language = language_of(request.language, machine.program, *data);
    if (!language) return fault(language.error());
    language->cpu = &tools.cpu;
    language->memory_bytes = request.limits.memory_bytes;
    auto program = read_script(opened, *language, tools.tell);
    if (!program) return tl::unexpected(program.error());
    language->dialect = grammar::dialect_named(program->dialect);
    if (program->inch) language->units = machine::ProgramUnits::inch;
    if (machine.process) {
        if (const auto fault_of_words = fault_of_process(*machine.process, *language->dialect))
            return fault(*fault_of_words);
    }
    auto setup = read_setup(request, *language, tools.tell);
    if (!setup) return fault(setup.error().message);
    CellChoice choice = cell_choice(found);
    choice.read = std::move(cell_read);
    auto cell = read_run_cell(choice, machine);
    if (!cell) return fault(cell.error());
    return RunInputs{.machine = std::move(machine),
                     .document = *std::move(document),
                     .data = *std::move(data),
                     .language = *std::move(language),
                     .program = *std::move(program),
                     .setup = *std::move(setup),
                     .module = {},
                     .cell = *std::move(cell),
                     .probe = *probe,
                     .overrides = *std::move(overrides)};
}

}  // namespace gsim::engine
