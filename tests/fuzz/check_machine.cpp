#include <fmt/format.h>

#include "base/toml/toml_writer.h"
#include "machine/file/controller_file.h"
#include "machine/file/machine_file.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/small_run.h"

namespace gsim::fuzz {
namespace {

/// A machine that was read can be planned for: moves come to an end, possibly an alarm.
Outcome move_it(machine::Machine machine) {
    Outcome outcome = outcome_of(run_moves({.machine = std::move(machine)}));
    outcome.accepted = true;  // the machine was read, whether or not it can make these moves
    return outcome;
}

/// With ranges and limits that the rules have to deal with.
machine::Machine machine_with(rrs::ControllerRules rules) {
    machine::Machine machine =
        machine::read_machine(machine::built_in_machine_toml(), "built-in machine").value();
    machine.controller = std::move(rules);
    return machine;
}

}  // namespace

Outcome check_machine(std::string_view toml) {
    const std::string file = name_beside(".toml");
    auto machine = machine::read_machine(toml, file);
    if (!machine) return refused_with(machine.error().message, file);
    const std::string printed = machine::print_machine(*machine);
    const auto repeated = machine::read_machine(printed, file);
    if (!repeated)
        return broken(fmt::format("what is printed is refused: {}\n{}", repeated.error().message, printed));
    if (*repeated != *machine)
        return broken(fmt::format("what is printed reads as another machine:\n{}", printed));
    return move_it(*std::move(machine));
}

Outcome check_controller(std::string_view toml) {
    const std::string file = name_beside(".toml");
    const auto rules = machine::read_controller(toml, file, "fuzz");
    if (!rules) return refused_with(rules.error().message, file);
    base::TomlWriter out;
    machine::print_controller(out, *rules);
    const std::string printed = out.release();
    if (printed.empty()) return accepted();  // as a machine without such a table
    const auto repeated = machine::read_controller(printed, file, "fuzz");
    if (!repeated)
        return broken(fmt::format("what is printed is refused: {}\n{}", repeated.error().message, printed));
    if (*repeated != *rules) return broken(fmt::format("what is printed reads as other rules:\n{}", printed));
    machine::Machine machine = machine_with(*rules);
    if (machine::find_controller_error(machine)) return accepted();
    return move_it(std::move(machine));
}

}  // namespace gsim::fuzz
