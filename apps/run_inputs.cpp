#include "apps/run_inputs.h"

#include <utility>

#include "apps/machine_data_file.h"
#include "apps/variables_file.h"
#include "runtime/cell/cell_file.h"
#include "runtime/machine/machine_file.h"
#include "runtime/rcs/rcs_machine.h"

namespace gsim::apps {

namespace {

tl::expected<machine::MachineDataDocument, std::string> read_data(const RunArguments& arguments,
                                                                  const machine::Machine& machine) {
    if (arguments.machine_data.empty()) return machine::MachineDataDocument(machine.axes);
    return open_machine_data(arguments.machine_data, machine.axes).map_error([](const auto& errors) {
        return errors.front();
    });
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
                                                                    const Language& language) {
    std::optional<script::Script> none;
    if (arguments.setup.empty()) return none;
    return read_script(arguments.setup, language)
        .map([](script::Script script) { return std::optional(std::move(script)); })
        .map_error([](InputError error) { return std::move(error.message); });
}

/// Null where no cell is asked for.
tl::expected<std::unique_ptr<simulation::CellWatch>, std::string> read_cell(const RunArguments& arguments,
                                                                            const machine::Machine& machine) {
    if (arguments.cell.empty()) return nullptr;
    return cell::load_cell(arguments.cell, machine).map([&](cell::Cell cell) {
        return std::make_unique<simulation::CellWatch>(std::move(cell), machine);
    });
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

}  // namespace

tl::expected<RunArguments, std::string> with_files_of_cell(RunArguments arguments) {
    if (arguments.cell.empty()) return arguments;
    return cell::load_cell_files(arguments.cell).map([&](const cell::CellFiles& files) {
        if (arguments.machine.empty()) arguments.machine = files.machine.string();
        if (arguments.machine_data.empty()) arguments.machine_data = files.machine_data.string();
        return std::move(arguments);
    });
}

tl::expected<machine::Machine, std::string> read_machine(const RunArguments& arguments) {
    if (!arguments.studies.check.empty()) return machine::load_machine(arguments.studies.check);
    if (arguments.machine.empty())
        return machine::read_machine(machine::built_in_machine_toml(), "built-in machine");
    return machine::load_machine(arguments.machine);
}

tl::expected<RunInputs, InputError> read_run_inputs(const RunArguments& arguments, machine::Machine machine) {
    const auto fault = [](std::string message) {
        return tl::unexpected(InputError{false, std::move(message)});
    };
    auto document = read_data(arguments, machine);
    if (!document) return fault(document.error());
    auto data = with_variables(arguments, document->data());
    if (!data) return fault(data.error());
    auto language = language_of(arguments.language, *data);
    if (!language) return fault(language.error());
    auto program = read_script(arguments.input, *language);
    if (!program) return tl::unexpected(program.error());
    language->dialect = grammar::dialect_named(program->dialect);
    auto setup = read_setup(arguments, *language);
    if (!setup) return fault(setup.error());
    auto module = load_module(arguments, machine);
    if (!module) return fault(module.error());
    auto cell = read_cell(arguments, machine);
    if (!cell) return fault(cell.error());
    return RunInputs{.machine = std::move(machine),
                     .document = *std::move(document),
                     .data = *std::move(data),
                     .language = *std::move(language),
                     .program = *std::move(program),
                     .setup = *std::move(setup),
                     .module = *std::move(module),
                     .cell = *std::move(cell)};
}

}  // namespace gsim::apps
