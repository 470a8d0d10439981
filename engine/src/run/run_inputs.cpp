#include "engine/src/run/run_inputs.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "collision/cell/cell_file.h"
#include "engine/src/conversions.h"
#include "engine/src/host_names.h"
#include "engine/src/run/language.h"
#include "engine/src/run/override_changes.h"
#include "engine/src/run/probe_options.h"
#include "engine/src/run/process_words.h"
#include "engine/src/run/variables_text.h"

namespace gsim::engine {

namespace {

Result<machine::MachineData> add_variables(const Request& request, machine::MachineData data) {
    if (request.variables.empty()) return data;
    return read_variables(request.host.files.impl(), request.variables)
        .map([&](const std::map<int, double>& variables) {
            for (const auto& [number, value] : variables) data.variables[number] = value;
            return std::move(data);
        });
}

// Sets the values that the request itself does not contain.
void add_cell_files(ResolvedRequest& found, const cell::CellFiles& files) {
    Request& request = found.request;
    if (request.machine.empty()) {
        request.machine = files.machine.string();
        found.machine_named_by = os::NameSource::in_file;
    }
    if (request.machine_data.empty()) {
        request.machine_data = files.machine_data.string();
        found.machine_data_named_by = os::NameSource::in_file;
    }
}

std::optional<gsim::Error> robots_contradiction(const Request& request) {
    for (const auto& [value, option] : {std::pair{&request.machine, "--machine"},
                                        {&request.machine_data, "--machine-data"},
                                        {&request.cell, "--cell"},
                                        {&request.probe, "--probe"},
                                        {&request.module, "--rcs"},
                                        {&request.variables, "--variables"}}) {
        if (!value->empty()) return fmt::format("{} cannot be combined with --robots", option);
    }
    return {};
}

std::string first_override(const OverrideOptions& options) {
    if (options.feed_percent) return "--feed-override";
    if (options.rapid_percent) return "--rapid-override";
    return options.spindle_percent ? "--spindle-override" : "--overrides";
}

}  // namespace

Result<machine::MachineDataDocument> read_request_data(const ResolvedRequest& found,
                                                       const MachineInput& input) {
    const Request& request = found.request;
    const machine::Machine& machine = input.machine;
    if (request.machine_data.empty()) {
        machine::MachineDataDocument document(machine.axes);
        if (!input.data) return document;
        return document.update(*input.data).map([&] { return document; });
    }
    const auto text = request.host.files.impl().read_text(request.machine_data, found.machine_data_named_by);
    if (!text) return tl::unexpected(text.error());
    return machine::MachineDataDocument::read(*text, request.machine_data, machine.axes)
        .map_error([](const std::vector<gsim::Error>& errors) { return errors.front(); });
}

Result<std::optional<rrs::RcsModule>> load_module(const Request& request, const machine::Machine& machine) {
    std::optional<rrs::RcsModule> none;
    if (request.module.empty()) return none;
    if (!request.host.load_module)
        return Unexpected(fmt::format("{}: controller modules are not supported here", request.module));
    return request.host.load_module(request.module, machine)
        .map([](const std::shared_ptr<rrs::RcsModule>& module) {
            return std::optional<rrs::RcsModule>(std::move(*module));
        });
}

std::optional<gsim::Error> find_contradiction(const Request& request) {
    if (!request.module.empty() && !request.overrides.is_default()) {
        return fmt::format(
            "{} cannot be combined with --rcs: a module has a separate override, SetOverrideSpeed",
            first_override(request.overrides));
    }
    return request.robots.empty() ? std::nullopt : robots_contradiction(request);
}

Result<Request> resolve_names(Request request) {
    for (const auto& [name, kind] : {std::pair{&request.machine_data, NameKind::sample},
                                     {&request.cell, NameKind::sample},
                                     {&request.robots, NameKind::sample},
                                     {&request.setup, NameKind::sample},
                                     {&request.overrides.file, NameKind::sample},
                                     {&request.library, NameKind::library},
                                     {&request.module, NameKind::module}}) {
        auto file = resolve_name(request.host, kind, *name);
        if (!file) return tl::unexpected(file.error());
        *name = *std::move(file);
    }
    return request;
}

Result<ResolvedRequest> resolve_files(Request request) {
    auto resolved_request = resolve_names(std::move(request));
    if (!resolved_request) return tl::unexpected(std::move(resolved_request.error()));
    ResolvedRequest found{.request = *std::move(resolved_request)};
    if (found.request.cell.empty()) return found;
    const std::string& cell = found.request.cell;
    auto text = found.request.host.files.impl().read_text(cell, os::NameSource::command_line);
    if (!text) return tl::unexpected(text.error());
    found.cell_text = *std::move(text);
    const auto files = cell::read_cell_files(found.cell_text, cell);
    if (!files) return tl::unexpected(files.error());
    add_cell_files(found, *files);
    return found;
}

Result<ResolvedRequest> resolve_machine_files(const Request& request) {
    Request machine_request;
    machine_request.machine = request.machine;
    machine_request.machine_data = request.machine_data;
    machine_request.cell = request.cell;
    machine_request.collisions = request.collisions;
    machine_request.host = request.host;
    return resolve_files(std::move(machine_request));
}

CellSource make_cell_source(const ResolvedRequest& found) {
    return {.file = found.request.cell,
            .text = found.cell_text,
            .collisions = found.request.collisions,
            .files = mesh_files(found.request.host)};
}

tl::expected<std::optional<script::Script>, Error> read_setup(const Request& request,
                                                              const Language& language,
                                                              const TextDiagnosticHandler& on_diagnostic) {
    std::optional<script::Script> none;
    if (request.setup.empty()) return none;
    return read_script(request.host.files.impl(), request.setup, language, on_diagnostic)
        .map([](script::Script script) { return std::optional(std::move(script)); });
}

tl::expected<RunInputs, Error> read_run_inputs(const ResolvedRequest& found, MachineInput input,
                                               std::shared_ptr<const cell::Cell> loaded_cell,
                                               OpenedScript& opened, const RunContext& tools) {
    const Request& request = found.request;
    machine::Machine& machine = input.machine;
    const auto unexpected_error = [](const gsim::Error& error) {
        return tl::unexpected(make_error(text::DiagnosticKind::input_file, error));
    };
    const auto probe = read_probe_options(request.probe, machine);
    if (!probe) return unexpected_error(probe.error());
    auto overrides = read_overrides(request.host.files.impl(), request.overrides, machine.controller);
    if (!overrides) return unexpected_error(overrides.error());
    auto document = read_request_data(found, input);
    if (!document) return unexpected_error(document.error());
    auto data = add_variables(request, document->data());
    if (!data) return unexpected_error(data.error());
    auto language = make_language(request.language, machine.program, *data);
    if (!language) return unexpected_error(language.error());
    language->cpu = &tools.cpu;
    language->memory_bytes = request.limits.memory_bytes;
    auto program = read_script(opened, *language, tools.on_diagnostic);
    if (!program) return tl::unexpected(program.error());
    language->dialect = grammar::find_dialect(program->dialect);
    if (program->inch) language->units = machine::ProgramUnits::inch;
    if (machine.process) {
        if (const auto word_error = find_process_error(*machine.process, *language->dialect))
            return unexpected_error(*word_error);
    }
    auto setup = read_setup(request, *language, tools.on_diagnostic);
    if (!setup) return unexpected_error(setup.error().message);
    CellSource options = make_cell_source(found);
    options.read = std::move(loaded_cell);
    auto cell = make_cell_monitor(options, machine);
    if (!cell) return unexpected_error(cell.error());
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
