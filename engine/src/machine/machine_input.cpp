#include "engine/src/machine/machine_input.h"

#include <fmt/format.h>

#include "base/os/files.h"
#include "engine/src/host_names.h"
#include "engine/src/run/process_words.h"
#include "machine/file/machine_file.h"
#include "machine/import/import_machine.h"

namespace gsim::engine {

namespace {

MachineInput from_control(import::Imported imported, const std::string& file) {
    MachineInput input;
    input.machine = std::move(imported.machine);
    if (imported.has_data) input.data = std::move(imported.data);
    input.notes = std::move(imported.warnings);
    if (!imported.left_out.empty()) {
        input.notes.push_back(
            fmt::format("{}: lines that are not taken over: {}; gsim-data import {} lists them", file,
                        imported.left_out.size(), file));
    }
    return input;
}

// The words that switch the process of a machine must be those of a dialect.
tl::expected<machine::Machine, std::string> read_machine_file(const std::string& text,
                                                              const std::string& file, const os::Files& files,
                                                              std::vector<std::string>* faults) {
    auto machine = machine::read_machine(text, file, files, faults);
    if (!machine || !machine->process) return machine;
    if (const auto fault = fault_of_process(*machine->process))
        return tl::unexpected(fmt::format("{}: {}", file, *fault));
    return machine;
}

tl::expected<MachineInput, std::string> read_input(const Host& host, const std::string& name,
                                                   os::NamedBy named_by, std::vector<std::string>* faults) {
    const auto plain = [](machine::Machine machine) { return MachineInput{std::move(machine), {}, {}}; };
    if (name.empty())
        return machine::read_machine(machine::built_in_machine_toml(), "built-in machine").map(plain);
    const auto file = find_name(host, NameKind::machine, name);
    if (!file) return tl::unexpected(file.error());
    const auto text = host.files.inner().read_text(*file, named_by);  // once: it may be a pipe
    if (!text) return tl::unexpected(text.error());
    if (!import::is_control_file(*text, *file))
        return read_machine_file(*text, *file, host.files.inner(), faults).map(plain);
    return import::import_machine(*text, *file, host.files.inner()).map([&](import::Imported imported) {
        return from_control(std::move(imported), *file);
    });
}

}  // namespace

tl::expected<MachineInput, std::string> read_machine_input(const Host& host, const std::string& name,
                                                           os::NamedBy named_by,
                                                           std::vector<std::string>* faults) {
    auto input = read_input(host, name, named_by, faults);
    if (!input && faults != nullptr && faults->empty()) faults->push_back(input.error());
    return input;
}

tl::expected<machine::ProgramTable, std::string> read_program_input(const Host& host,
                                                                    const std::string& name) {
    const auto file = find_name(host, NameKind::machine, name);
    if (!file) return tl::unexpected(file.error());
    const auto text = host.files.inner().read_text(*file, os::NamedBy::command_line);
    if (!text) return tl::unexpected(text.error());
    if (!import::is_control_file(*text, *file)) return machine::read_program_table(*text, *file);
    return import::import_machine(*text, *file, host.files.inner()).map([](const import::Imported& imported) {
        return imported.machine.program;
    });
}

}  // namespace gsim::engine
