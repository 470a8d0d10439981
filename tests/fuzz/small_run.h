#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "collision/cell/cell.h"
#include "controller/module/rcs_host.h"
#include "machine/model/machine.h"
#include "motion/planner/override_schedule.h"
#include "runtime/report/report.h"
#include "tests/fuzz/target.h"

namespace gsim::fuzz {

/// Script on a machine. The run ends within some milliseconds for any script: it may take some blocks, steps
/// and memory, and some minutes of the machine's time.
struct SmallRun {
    machine::Machine machine;
    std::string lua;
    std::string dialect = "ab9";
    std::string file_name = "fuzz.lua";
    std::int64_t line_offset = 0;  ///< As script::Script has it.
};

/// Conditions of some moves.
struct MovesRun {
    machine::Machine machine;
    motion::OverrideSchedule overrides = {};
    std::optional<cell::Cell> cell = {};        ///< Cell of the machine.
    std::optional<rrs::RcsModule> module = {};  ///< Its controller in place of our own.
};

/// End of a run, and what was found during the run.
struct RunResult {
    simulation::Report report;
    double greatest_step = 0;           ///< Max step of the axes, mm or deg.
    std::optional<std::string> broken;  ///< Moves or segments that do not join.
};

/// Runs a script once.
RunResult run_once(const SmallRun& run);

/// Makes rapids, lines, an arc, a dwell and corners within 60 mm of the machine's home, with what it has of
/// X, Y and Z, without any script.
RunResult run_moves(MovesRun run);

/// Returns which promise a report breaks: it is JSON, its values are finite and add up, and it has an alarm
/// if the run did not complete. If it did, all axes stayed within their ranges.
std::optional<std::string> fault_of_report(const RunResult& result);

/// Returns the outcome of a run: accepted if it completed or was past limits.
Outcome outcome_of(const RunResult& result);

/// Runs it, and some programs twice, which must give the same report.
Outcome check_run(const SmallRun& run);

}  // namespace gsim::fuzz
