#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/store/sqlite.h"
#include "batch/work/run_commands.h"
#include "batch/work/run_row.h"

namespace gsim::batch {

/// Stored data of a run in addition to its RunSummary.
struct RunDetails {
    std::string key = {};  ///< By which it is found again.
    std::string program = {}, machine = {};
    std::string program_sha256 = {}, machine_sha256 = {};
    std::string machine_name = {}, controller = {}, version = {}, run_at = {};
    std::string options = {}, settings = {}, extents = {}, findings = {};  ///< JSON.
    std::optional<double> energy_j = {};
    RunTimes times = {};
    RunDistances distances = {};
    RunCounts counts = {};
    std::string picture_svg = {};      ///< If it was kept.
    std::vector<ReadFile> files = {};  ///< All that it read or looked for, by name.
};

inline RunInputs run_inputs(const RunDetails& run) {
    return {run.program, run.machine, run.options, run.settings};
}

/// Reader of complete runs, one by one. It must be destroyed before its database.
class RunHistory {
  public:
    static Result<RunHistory> open(Database& results);

    Result<RunDetails> read(std::int64_t run);

  private:
    RunHistory(Statement run, Statement files, Statement picture)
        : run_(std::move(run)), files_(std::move(files)), picture_(std::move(picture)) {}

    Statement run_, files_, picture_;
};

}  // namespace gsim::batch
