#include <vector>

#include <fmt/format.h>

#include "batch/store/results.h"

namespace gsim::batch {

namespace {

// All columns except the id.
constexpr const char* kColumns =
    "key, program, program_sha256, machine, machine_sha256, machine_name, controller, options, settings, "
    "version, "
    "ran_at, status, cause, message, file, line, cycle_time_s, cycle_time_min_s, cycle_time_max_s, rapid_s, "
    "feed_s, dwell_s, "
    "rapid_mm, "
    "feed_mm, process_on_mm, blocks, moves, violations, collisions, process_findings, warnings, energy_j, "
    "extents, "
    "findings, cpu_s, clearance_mm, deviation_mm, joint_speed_share, lower_bound_s";

struct JobRun {
    std::int64_t job = 0, run = 0;
};

/// Returns the jobs of the other file that have no run here, in their order.
Result<std::vector<JobRun>> find_missing_runs(Database& database, std::int64_t batch) {
    // A process that was killed at once leaves a file without tables.
    auto tables = database.prepare("SELECT count(*) FROM other.sqlite_schema WHERE name = 'batch_run'");
    if (!tables) return Unexpected(tables.error());
    if (const auto row = tables->step(); !row || tables->integer(0) == 0)
        return row ? Result<std::vector<JobRun>>() : Unexpected(row.error());
    // The newest run of each job is taken, because a requeued task has begun another batch in the same file.
    auto rows = database.prepare(
        "SELECT theirs.job, theirs.run FROM other.batch_run theirs JOIN (SELECT job, max(batch) AS batch "
        "FROM "
        "other.batch_run GROUP BY job) newest ON newest.job = theirs.job AND newest.batch = theirs.batch "
        "WHERE NOT "
        "EXISTS (SELECT 1 FROM main.batch_run ours WHERE ours.batch = ? AND ours.job = theirs.job) ORDER BY "
        "theirs.job");
    if (!rows) return Unexpected(rows.error());
    rows->bind(1, batch);
    std::vector<JobRun> pairs;
    while (true) {
        const auto row = rows->step();
        if (!row) return Unexpected(row.error());
        if (!*row) return pairs;
        pairs.push_back({rows->integer(0), rows->integer(1)});
    }
}

/// Copier of runs from a database that is attached as `other`.
class Copier {
  public:
    static Result<Copier> of(Database& database) {
        Copier copier;
        for (
            const auto& [statement, sql] :
            {std::pair{
                 &copier.run_,
                 fmt::format("INSERT INTO main.run ({0}) SELECT {0} FROM other.run WHERE id = ? RETURNING id",
                             kColumns)},
             {&copier.setting_,
              std::string("INSERT INTO main.setting SELECT ?, name, value FROM other.setting WHERE run = ?")},
             {&copier.report_,
              std::string("INSERT INTO main.report SELECT ?, json FROM other.report WHERE run = ?")},
             {&copier.picture_,
              std::string("INSERT INTO main.picture SELECT ?, svg FROM other.picture WHERE run = ?")},
             {&copier.input_,
              std::string(
                  "INSERT OR IGNORE INTO main.input (file, sha256) SELECT file, sha256 FROM other.input JOIN "
                  "other.run_input ON input = id WHERE run = ?")},
             {&copier.run_input_,
              std::string(
                  "INSERT INTO main.run_input SELECT ?, ours.id FROM other.run_input JOIN other.input theirs "
                  "ON theirs.id = input JOIN main.input ours ON ours.file = theirs.file AND ours.sha256 = "
                  "theirs.sha256 WHERE run = ?")}}) {
            auto prepared = database.prepare(sql);
            if (!prepared) return Unexpected(prepared.error());
            statement->emplace(*std::move(prepared));
        }
        return copier;
    }

    /// Copies a run; returns its number in this file.
    Result<std::int64_t> copy(std::int64_t run) {
        run_->bind(1, run);
        const auto row = run_->step();
        if (!row) return Unexpected(row.error());
        if (!*row) return Unexpected(fmt::format("run {} not found", run));
        const std::int64_t new_run = run_->integer(0);
        input_->bind(1, run);
        for (std::optional<Statement>* each : {&setting_, &report_, &picture_, &run_input_})
            (*each)->bind(1, new_run).bind(2, run);
        return run_->run()
            .and_then([&] { return setting_->run(); })
            .and_then([&] { return report_->run(); })
            .and_then([&] { return picture_->run(); })
            .and_then([&] { return input_->run(); })
            .and_then([&] { return run_input_->run(); })
            .map([&] { return new_run; });
    }

  private:
    std::optional<Statement> run_, setting_, report_, picture_, input_, run_input_;
};

}  // namespace

Result<std::uint64_t> Results::merge(const std::string& file) {
    // SQLite attaches no database within a transaction.
    auto attach = database_.execute("COMMIT").and_then([&]() -> Result<void> {
        auto statement = database_.prepare("ATTACH DATABASE ? AS other");
        if (!statement) return Unexpected(statement.error());
        statement->bind(1, file);
        return statement->run();
    });
    if (!attach) {
        // The following changes belong to the batch as before.
        static_cast<void>(database_.execute("BEGIN IMMEDIATE"));
        return Unexpected(attach.error());
    }
    auto merge_result = [&]() -> Result<std::uint64_t> {
        if (const auto begun = database_.execute("BEGIN IMMEDIATE"); !begun) return Unexpected(begun.error());
        const auto pairs = find_missing_runs(database_, batch_);
        if (!pairs) return Unexpected(pairs.error());
        if (pairs->empty()) return 0;
        auto copier = Copier::of(database_);
        if (!copier) return Unexpected(copier.error());
        for (const JobRun& pair : *pairs) {
            const auto run = copier->copy(pair.run);
            if (!run) return Unexpected(run.error());
            if (const auto done = record(static_cast<std::uint64_t>(pair.job), *run, false); !done)
                return Unexpected(done.error());
        }
        return pairs->size();
    }();
    const auto detached = database_.execute(merge_result ? "COMMIT" : "ROLLBACK").and_then([&] {
        return database_.execute("DETACH DATABASE other; BEGIN IMMEDIATE");
    });
    if (!merge_result) return merge_result;
    if (!detached) return Unexpected(detached.error());
    return merge_result;
}

}  // namespace gsim::batch
