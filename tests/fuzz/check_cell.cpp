#include <array>

#include <fmt/format.h>

#include "collision/cell/cell_file.h"
#include "engine/src/run/override_changes.h"
#include "grammar/dialect.h"
#include "machine/file/machine_file.h"
#include "runtime/processes/robots_file.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/small_run.h"

namespace gsim::fuzz {
namespace {

/// Max items of a cell that a run uses: thousands of bodies would only take time.
constexpr std::size_t kMostItems = 30;

machine::Machine cell_machine() {
    return machine::read_machine(machine::built_in_machine_toml(), "built-in machine").value();
}

}  // namespace

Outcome check_cell(std::string_view toml) {
    const std::string file = name_beside(".toml");
    const std::array<std::string, 1> conveyors{"belt"};
    const machine::Machine machine = cell_machine();
    const auto files = cell::read_cell_files(toml, file);
    auto cell = cell::read_cell(toml, file, machine, conveyors);
    if (!files) {
        if (cell) return broken("a cell is read whose head is refused: " + files.error().message);
        return refused_with(files.error().message, file);
    }
    if (!cell) return refused_with(cell.error().message, file);
    for (const auto& [first, second] : cell->ignored) {
        if (first >= cell->items.size() || second >= cell->items.size())
            return broken("a pair to be ignored names no body");
    }
    if (cell->items.size() > kMostItems) return accepted();
    Outcome outcome = outcome_of(run_moves({.machine = machine, .cell = *std::move(cell)}));
    outcome.accepted = true;
    return outcome;
}

Outcome check_robots(std::string_view toml) {
    const std::string file = name_beside(".toml");
    const auto robots = process::read_robots(toml, file, grammar::dialect_names());
    if (!robots) return refused_with(robots.error().message, file);
    if (robots->robots.empty()) return broken("a file without robots is read");
    for (const process::RobotEntry& robot : robots->robots) {
        if (robot.name.empty()) return broken("a robot without a name is read");
        if (!robot.base.matrix().allFinite()) return broken("a robot stands nowhere");
    }
    return accepted();
}

Outcome check_overrides(std::string_view toml) {
    const std::string file = name_beside(".toml");
    machine::Machine machine = cell_machine();
    const auto schedule = engine::read_override_changes(toml, file, {}, machine.controller);
    if (!schedule) return refused_with(schedule.error().message, file);
    return outcome_of(run_moves({.machine = std::move(machine), .overrides = *schedule}));
}

}  // namespace gsim::fuzz
