#include "batch/store/results.h"

#include <ctime>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "batch/store/schema.h"

namespace gsim::batch {

namespace {

std::string now_utc() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

std::string new_token() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

std::int64_t as_int64(std::uint64_t number) {
    return static_cast<std::int64_t>(number);
}

Result<std::int64_t> query_number(Database& database, const char* query) {
    auto prepared_query = database.prepare(query);
    if (!prepared_query) return Unexpected(prepared_query.error());
    const auto row = prepared_query->step();
    if (!row) return Unexpected(row.error());
    return *row ? prepared_query->integer(0) : 0;
}

/// Returns the statements that make tables of a version those of kSchemaVersion.
std::string upgrade_sql(std::int64_t version) {
    std::string sql;
    if (version < 2) {
        sql += kVersion2Tables;
        for (const char* metric : kVersion2Columns)
            sql += fmt::format("ALTER TABLE run ADD COLUMN {} REAL;\n", metric);
    }
    return sql + kVersion3Names + fmt::format("PRAGMA user_version = {};", kSchemaVersion);
}

bool is_upgradable(std::int64_t version) {
    return version >= 1 && version < kSchemaVersion;
}

Result<void> create_tables(Database& database) {
    return database.execute(fmt::format("BEGIN; {} PRAGMA application_id = {}; {} COMMIT;", kSchema,
                                        kApplicationId, upgrade_sql(1)));
}

/// A new file gets its tables, an existing one must have them.
Result<void> check_or_create_tables(Database& database) {
    const auto tables = query_number(database, "SELECT count(*) FROM sqlite_schema");
    if (!tables) return Unexpected(tables.error());
    if (*tables == 0) return create_tables(database);
    const auto application = query_number(database, "PRAGMA application_id");
    const auto version = query_number(database, "PRAGMA user_version");
    if (!application || *application != kApplicationId)
        return Unexpected(fmt::format("'{}' is not a results file", database.file()));
    if (version && is_upgradable(*version))
        return database.execute(fmt::format("BEGIN; {} COMMIT;", upgrade_sql(*version)));
    if (!version || *version != kSchemaVersion)
        return Unexpected(
            fmt::format("'{}' is of another version of this program; use a new file", database.file()));
    return {};
}

/// Returns true if a database has the identification of gsim, and an earlier version of its tables.
bool has_earlier_version(Database& database) {
    const auto application = query_number(database, "PRAGMA application_id");
    return application && *application == kApplicationId &&
           is_upgradable(query_number(database, "PRAGMA user_version").value_or(0));
}

/// Returns the number of a statement that gives one row with one number.
Result<std::int64_t> read_integer(Statement& statement) {
    const auto row = statement.step();
    if (!row) return Unexpected(row.error());
    const std::int64_t number = *row ? statement.integer(0) : 0;
    if (const auto done = statement.run(); !done) return Unexpected(done.error());
    return number;
}

/// True if a run may succeed with more time or memory, or without being ended from outside.
bool may_succeed_on_retry(std::string_view status, std::string_view message) {
    return status == "crashed" || status == "timeout" || status == "memory" ||
           (status != "completed" && message.find("memory") != std::string_view::npos);
}

}  // namespace

void upgrade_schema(const std::string& file) {
    auto before = Database::open(file, true);
    if (!before || !has_earlier_version(*before)) return;
    if (auto database = Database::open(file)) static_cast<void>(check_or_create_tables(*database));
}

struct Results::Statements {
    Statement begin_batch, end_batch, find, inputs, add, setting, input, run_input, report, picture, record;
};

Results::Results(Database database, std::unique_ptr<Statements> statements)
    : database_(std::move(database)), statements_(std::move(statements)) {}
Results::Results(Results&&) noexcept = default;

Results::~Results() {
    // Statements must be destroyed before their database. Data not committed by then is up to the caller.
    statements_.reset();
}

Result<Results> Results::open(const std::string& file, Journal journal) {
    auto database = Database::open(file);
    if (!database) return Unexpected(database.error());
    const char* mode = journal == Journal::write_ahead
                           ? "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;"
                           : "PRAGMA journal_mode = DELETE;";
    if (const auto set = database->execute(mode); !set) return Unexpected(set.error());
    if (const auto created = check_or_create_tables(*database); !created) return Unexpected(created.error());
    const auto prepared = [&](std::string_view sql) {
        auto statement = database->prepare(sql);
        if (!statement)
            throw std::runtime_error("internal error, an SQL statement is not valid: " +
                                     statement.error().message);
        return *std::move(statement);
    };
    auto statements = std::make_unique<Statements>(Statements{
        prepared(
            "INSERT INTO batch (token, plan, version, began_at, jobs) VALUES (?, ?, ?, ?, ?) RETURNING id"),
        prepared("UPDATE batch SET ended_at = ?, complete = ? WHERE id = ?"),
        prepared("SELECT run.id, status, report.run IS NOT NULL, cause, message, picture.run IS NOT NULL "
                 "FROM run LEFT "
                 "JOIN report ON report.run = run.id LEFT JOIN picture ON picture.run = run.id WHERE key = ? "
                 "ORDER BY run.id DESC"),
        prepared("SELECT file, sha256 FROM run_input JOIN input ON input.id = run_input.input WHERE run = ?"),
        prepared(
            "INSERT INTO run (key, program, program_sha256, machine, machine_sha256, machine_name, "
            "controller, options, settings, version, ran_at, status, cause, message, file, line, "
            "cycle_time_s, "
            "cycle_time_min_s, cycle_time_max_s, rapid_s, feed_s, dwell_s, rapid_mm, feed_mm, process_on_mm, "
            "blocks, moves, "
            "violations, collisions, process_findings, warnings, energy_j, extents, findings, cpu_s, "
            "clearance_mm, deviation_mm, joint_speed_share, lower_bound_s) VALUES "
            "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
            "?, ?, ?, ?, ?, ?, ?, ?) RETURNING id"),
        prepared("INSERT INTO setting (run, name, value) VALUES (?, ?, ?)"),
        prepared(
            "INSERT INTO input (file, sha256) VALUES (?, ?) ON CONFLICT (file, sha256) DO UPDATE SET file = "
            "file RETURNING id"),
        prepared("INSERT OR IGNORE INTO run_input (run, input) VALUES (?, ?)"),
        prepared("INSERT INTO report (run, json) VALUES (?, ?)"),
        prepared("INSERT INTO picture (run, svg) VALUES (?, ?)"),
        prepared("INSERT OR REPLACE INTO batch_run (batch, job, run, reused) VALUES (?, ?, ?, ?)")});
    return Results(*std::move(database), std::move(statements));
}

Result<void> Results::begin_batch(const std::string& plan, std::uint64_t jobs, const std::string& version) {
    if (auto begun = database_.execute("BEGIN IMMEDIATE"); !begun) return begun;
    Statement& add = statements_->begin_batch;
    token_ = new_token();
    add.bind(1, token_).bind(2, plan).bind(3, version).bind(4, now_utc()).bind(5, as_int64(jobs));
    return read_integer(add).map([&](std::int64_t batch) { batch_ = batch; });
}

Result<void> Results::resume_batch(std::int64_t batch, const std::string& token) {
    auto known = database_.prepare("SELECT count(*) FROM batch WHERE id = ? AND token = ?");
    if (!known) return Unexpected(known.error());
    known->bind(1, batch).bind(2, token);
    const auto count = read_integer(*known);
    if (!count) return Unexpected(count.error());
    if (*count == 0) return Unexpected(fmt::format("batch {} is not in '{}'", batch, database_.file()));
    batch_ = batch;
    token_ = token;
    return database_.execute("BEGIN IMMEDIATE");
}

Result<std::uint64_t> Results::recorded() {
    auto count = database_.prepare("SELECT count(*) FROM batch_run WHERE batch = ?");
    if (!count) return Unexpected(count.error());
    count->bind(1, batch_);
    return read_integer(*count).map([](std::int64_t number) { return static_cast<std::uint64_t>(number); });
}

Result<void> Results::end_batch(bool complete) {
    statements_->end_batch.bind(1, now_utc()).bind(2, std::int64_t{complete}).bind(3, batch_);
    return statements_->end_batch.run().and_then([&] { return database_.execute("COMMIT"); });
}

Result<void> Results::commit() {
    return database_.execute("COMMIT; BEGIN IMMEDIATE");
}

Result<bool> Results::is_current(std::int64_t run, const FileHash& file_hash) {
    Statement& inputs = statements_->inputs;
    inputs.bind(1, run);
    bool current = true;
    while (true) {
        const auto row = inputs.step();
        if (!row) return Unexpected(row.error());
        if (!*row) return current;
        current = current && file_hash(std::string(inputs.text(0))) == inputs.text(1);
    }
}

Result<std::optional<Results::StoredRun>> Results::find(const std::string& key, const FileHash& file_hash,
                                                        StoredDocuments requested, bool retry) {
    std::vector<StoredRun> candidates, lost_runs;
    Statement& find = statements_->find;
    find.bind(1, key);
    while (true) {
        const auto row = find.step();
        if (!row) return Unexpected(row.error());
        if (!*row) break;
        const bool lost = may_succeed_on_retry(find.text(1), find.text(4));
        // A run that ended without a report will not get one.
        if (retry && lost) continue;
        const bool has_documents =
            (!requested.report || find.integer(2) != 0) && (!requested.picture || find.integer(5) != 0);
        if (has_documents || lost || find.text(1) == "refused")
            (lost ? lost_runs : candidates)
                .push_back({find.integer(0), find.text(1) == "completed" && find.text(3).empty()});
    }
    // The inputs of a run that lost its process are unknown, so it counts only if no better run exists.
    candidates.insert(candidates.end(), lost_runs.begin(), lost_runs.end());
    for (const StoredRun& found : candidates) {
        const auto current = is_current(found.run, file_hash);
        if (!current) return Unexpected(current.error());
        if (*current) return found;
    }
    return std::nullopt;
}

Result<std::int64_t> Results::add(const Job& job, const RunKey& key, const RunRow& row,
                                  const std::string& version) {
    Statement& add = statements_->add;
    int at = 0;
    const auto bind_next = [&](const auto& value) { add.bind(++at, value); };
    for (const std::string& text :
         {key.key, job.program, key.program_sha256, job.machine, key.machine_sha256, row.machine,
          row.controller, job.options.dump(), settings_json(job.settings).dump(), version, now_utc(),
          row.outcome.status, row.outcome.cause, row.outcome.message, row.outcome.file})
        bind_next(std::string_view(text));
    bind_next(std::int64_t{row.outcome.line});
    for (const std::optional<double> metric :
         {std::optional(row.times.cycle_s), row.times.min_s, row.times.max_s,
          std::optional(row.times.rapid_s), std::optional(row.times.feed_s), std::optional(row.times.dwell_s),
          std::optional(row.distances.rapid_mm), std::optional(row.distances.feed_mm),
          std::optional(row.distances.process_on_mm)})
        bind_next(metric);
    for (const std::uint64_t count :
         {row.counts.blocks, row.counts.moves, row.counts.violations, row.counts.collisions,
          row.counts.process_findings, row.counts.warnings})
        bind_next(as_int64(count));
    bind_next(row.energy_j);
    bind_next(std::string_view(row.extents));
    bind_next(std::string_view(row.findings));
    for (const std::optional<double> metric : {std::optional(row.cpu_s), row.clearance_mm, row.deviation_mm,
                                               row.joint_speed_share, row.times.lower_bound_s})
        bind_next(metric);
    auto run = read_integer(add);
    if (!run) return run;
    for (const SettingValue& setting : job.settings) {
        statements_->setting.bind(1, *run).bind(2, setting.key);
        if (setting.value.is_number()) {
            statements_->setting.bind(3, std::optional(setting.value.get<double>()));
        } else {
            statements_->setting.bind(
                3, setting.value.is_string() ? setting.value.get<std::string>() : setting.value.dump());
        }
        if (const auto done = statements_->setting.run(); !done) return Unexpected(done.error());
    }
    if (const auto done = add_inputs(*run, row); !done) return Unexpected(done.error());
    if (!row.documents.report.empty()) {
        statements_->report.bind(1, *run).bind(2, row.documents.report);
        if (const auto done = statements_->report.run(); !done) return Unexpected(done.error());
    }
    if (!row.documents.picture.empty()) {
        statements_->picture.bind(1, *run).bind(2, row.documents.picture);
        if (const auto done = statements_->picture.run(); !done) return Unexpected(done.error());
    }
    return run;
}

Result<void> Results::add_inputs(std::int64_t run, const RunRow& row) {
    for (const ReadFile& file : row.files) {
        statements_->input.bind(1, file.name).bind(2, file.sha256);
        const auto input = read_integer(statements_->input);
        if (!input) return Unexpected(input.error());
        statements_->run_input.bind(1, run).bind(2, *input);
        if (auto done = statements_->run_input.run(); !done) return done;
    }
    return {};
}

Result<void> Results::record(std::uint64_t job, std::int64_t run, bool reused) {
    statements_->record.bind(1, batch_).bind(2, as_int64(job)).bind(3, run).bind(4, std::int64_t{reused});
    return statements_->record.run();
}

}  // namespace gsim::batch
