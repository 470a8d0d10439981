#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Data of a batch from its database row and its runs.
struct BatchSummary {
    std::int64_t id = 0;
    std::string plan, version;
    std::string started_at, ended_at;  ///< UTC, as of ISO 8601; empty: it has not ended, or was cut off.
    std::int64_t jobs = 0;
    bool complete = false;
    std::int64_t runs = 0, failed = 0, reused = 0;  ///< Jobs that have a run, and of which kind.
};

/// Results of a run that are compared between runs.
struct RunSummary {
    std::int64_t id = 0;
    std::string status, cause, message, file;
    std::int64_t line = 0;
    double time_s = 0;
    std::int64_t violations = 0, collisions = 0, process_findings = 0, warnings = 0;

    bool is_clean() const { return status == "completed" && cause.empty(); }
    /// A run past limits or with a collision is complete as well, so its time is that of the program.
    bool has_time() const { return status == "completed" || status == "violations"; }
    std::int64_t findings() const { return violations + collisions + process_findings; }
};

/// Run of a case in a batch.
struct HistoryEntry {
    std::size_t batch = 0;  ///< Index in NightlyReport::batches.
    const RunSummary* run = nullptr;
};

/// Program on a machine in one variant of the settings: the unit by which two batches are compared.
struct Case {
    std::string program, machine, settings;  ///< Settings as JSON.
    const RunSummary* now = nullptr;         ///< Null: the case is gone.
    const RunSummary* before = nullptr;      ///< Null: the case is new.
    bool is_reused = false;
    std::size_t position = 0;                ///< Among those of its program, from 0.
    bool has_details = false;                ///< On its program's page, which has space for some.
    std::vector<HistoryEntry> history = {};  ///< By batch; the latest one, too.
};

/// All cases of one program, by their indices in NightlyReport::cases.
struct ProgramCases {
    std::string program;
    std::string page;  ///< Name of its file.
    std::vector<std::size_t> cases = {};
};

/// Comparison of the latest batch with an earlier one, and its history.
struct NightlyReport {
    BatchSummary latest;
    std::optional<BatchSummary> before = std::nullopt;
    std::vector<BatchSummary> batches = {};   ///< The last ones with the latest, in the order of time.
    std::int64_t older_batches = 0;           ///< That are left out of these.
    std::vector<Case> cases = {};             ///< In the order of the jobs, followed by those that are gone.
    std::vector<ProgramCases> programs = {};  ///< For the latest batch, in the order of the jobs.
    std::unordered_map<std::int64_t, RunSummary> runs = {};  ///< To which cases point.

    explicit NightlyReport(BatchSummary of) : latest(std::move(of)) {}
    NightlyReport(const NightlyReport&) = delete;
    NightlyReport(NightlyReport&&) = default;
    NightlyReport& operator=(const NightlyReport&) = delete;
    NightlyReport& operator=(NightlyReport&&) = default;
    ~NightlyReport() = default;
};

/// Reads the nightly report; `since` is the number of the previous batch, 0: the last one before, if any. The
/// error is a message: no batch, or none of that number before the latest.
Result<NightlyReport> read_nightly_report(Database& results, std::int64_t since);

}  // namespace gsim::batch
