#include "batch/pages/nightly_report.h"

#include <utility>

#include <fmt/format.h>

#include "batch/pages/page_name.h"

namespace gsim::batch {

namespace {

constexpr std::int64_t kMaxBatches = 90;  // of a history
constexpr std::size_t kMaxDetails = 40;   // of a program's page
constexpr std::size_t kNoCase = static_cast<std::size_t>(-1);
constexpr std::string_view kBatchQuery =
    "SELECT id, plan, version, began_at, coalesce(ended_at, ''), jobs, complete FROM batch ";
constexpr std::string_view kRunQuery =
    "SELECT program, machine, settings, status, cause, message, file, line, cycle_time_s, violations, "
    "collisions, process_findings, warnings FROM run WHERE id = ?";

/// Reader of the results. Copies of a job have one run, so the first copy represents all.
class NightlyReportReader {
  public:
    explicit NightlyReportReader(Database& results) : results_(results) {}

    Result<NightlyReport> read(std::int64_t since) {
        auto run = results_.prepare(kRunQuery);
        if (!run) return Unexpected(run.error());
        run_ = *std::move(run);
        auto batches = read_batches(fmt::format("ORDER BY id DESC LIMIT {}", kMaxBatches));
        if (!batches) return Unexpected(batches.error());
        if (batches->empty()) return Unexpected(fmt::format("'{}' contains no batch", results_.file()));
        auto before = find_previous_batch(*batches, since);
        if (!before) return Unexpected(before.error());
        NightlyReport report(batches->front());
        report.before = *std::move(before);
        report.batches.assign(batches->rbegin(), batches->rend());
        const auto done =
            count_older_batches(report).and_then([&] { return read_compared_runs(report); }).and_then([&] {
                return read_history(report);
            });
        if (!done) return Unexpected(done.error());
        sort_by_program(report);
        return report;
    }

  private:
    Result<std::vector<BatchSummary>> read_batches(const std::string& row_condition) {
        auto rows = results_.prepare(fmt::format("{}{}", kBatchQuery, row_condition));
        if (!rows) return Unexpected(rows.error());
        std::vector<BatchSummary> batches;
        while (true) {
            const auto row = rows->step();
            if (!row) return Unexpected(row.error());
            if (!*row) return batches;
            batches.push_back({.id = rows->integer(0),
                               .plan = std::string(rows->text(1)),
                               .version = std::string(rows->text(2)),
                               .started_at = std::string(rows->text(3)),
                               .ended_at = std::string(rows->text(4)),
                               .jobs = rows->integer(5),
                               .complete = rows->integer(6) != 0});
        }
    }

    Result<std::optional<BatchSummary>> find_previous_batch(const std::vector<BatchSummary>& batches,
                                                            std::int64_t since) {
        if (since == 0) return batches.size() > 1 ? std::optional(batches[1]) : std::nullopt;
        auto found = read_batches(fmt::format("WHERE id = {}", since));
        if (!found) return Unexpected(found.error());
        if (found->empty() || since >= batches.front().id)
            return Unexpected(
                fmt::format("there is no batch {} before the latest one in '{}'", since, results_.file()));
        return found->front();
    }

    Result<void> count_older_batches(NightlyReport& report) {
        auto count = results_.prepare("SELECT count(*) FROM batch");
        if (!count) return Unexpected(count.error());
        const auto row = count->step();
        if (!row) return Unexpected(row.error());
        report.older_batches = count->integer(0) - static_cast<std::int64_t>(report.batches.size());
        return {};
    }

    Result<void> read_compared_runs(NightlyReport& report) {
        const auto now = [&](std::size_t position, const RunSummary& run, bool reused) {
            Case& of = report.cases[position];
            if (of.now == nullptr) of.is_reused = reused;
            if (of.now == nullptr) of.now = &run;
        };
        const auto before = [&](std::size_t position, const RunSummary& run, bool) {
            Case& of = report.cases[position];
            if (of.before == nullptr) of.before = &run;
        };
        auto result = for_each_run(report, report.latest, true, now);
        if (!result || !report.before) return result;
        return for_each_run(report, *report.before, true, before);
    }

    Result<void> read_history(NightlyReport& report) {
        for (std::size_t i = 0; i < report.batches.size(); ++i) {
            auto result = for_each_run(report, report.batches[i], false,
                                       [&](std::size_t position, const RunSummary& run, bool) {
                                           auto& history = report.cases[position].history;
                                           if (history.empty() || history.back().batch != i)
                                               history.push_back({i, &run});
                                       });
            if (!result) return result;
        }
        return {};
    }

    /// Calls `on_run` with case and run of each job of a batch. Unknown cases are added or left out.
    template <typename Visitor>
    Result<void> for_each_run(NightlyReport& report, BatchSummary& batch, bool add_missing,
                              const Visitor& on_run) {
        auto rows = results_.prepare("SELECT run, reused FROM batch_run WHERE batch = ? ORDER BY job");
        if (!rows) return Unexpected(rows.error());
        rows->bind(1, batch.id);
        batch.runs = batch.failed = batch.reused = 0;
        while (true) {
            const auto row = rows->step();
            if (!row) return Unexpected(row.error());
            if (!*row) return {};
            const std::int64_t id = rows->integer(0);
            const bool reused = rows->integer(1) != 0;
            const auto position = find_case(report, id, add_missing);
            if (!position) return Unexpected(position.error());
            const RunSummary& run = report.runs.at(id);
            ++batch.runs;
            batch.failed += run.is_clean() ? 0 : 1;
            batch.reused += reused ? 1 : 0;
            if (*position != kNoCase) on_run(*position, run, reused);
        }
    }

    /// Returns the case index. A run is read once, for any number of batches.
    Result<std::size_t> find_case(NightlyReport& report, std::int64_t id, bool add_if_missing) {
        if (const auto known = case_by_run_.find(id); known != case_by_run_.end()) return known->second;
        run_->bind(1, id);
        const auto row = run_->step();
        if (!row || !*row)
            return Unexpected(row ? fmt::format("run {} is not in '{}'", id, results_.file())
                                  : row.error().message);
        const auto text = [&](int column) { return std::string(run_->text(column)); };
        report.runs[id] = {.id = id,
                           .status = text(3),
                           .cause = text(4),
                           .message = text(5),
                           .file = text(6),
                           .line = run_->integer(7),
                           .time_s = run_->number(8),
                           .violations = run_->integer(9),
                           .collisions = run_->integer(10),
                           .process_findings = run_->integer(11),
                           .warnings = run_->integer(12)};
        Case of{.program = text(0), .machine = text(1), .settings = text(2)};
        if (const auto read = run_->run(); !read) return Unexpected(read.error());
        return case_by_run_[id] = find_or_add_case(report, std::move(of), add_if_missing);
    }

    std::size_t find_or_add_case(NightlyReport& report, Case of, bool add_if_missing) {
        const std::string key = of.program + '\0' + of.machine + '\0' + of.settings;
        if (const auto known = positions_.find(key); known != positions_.end()) return known->second;
        if (!add_if_missing) return kNoCase;
        report.cases.push_back(std::move(of));
        return positions_[key] = report.cases.size() - 1;
    }

    static void sort_by_program(NightlyReport& report) {
        std::unordered_map<std::string, std::size_t> known;
        for (std::size_t i = 0; i < report.cases.size(); ++i) {
            Case& each = report.cases[i];
            if (each.now == nullptr) continue;
            const auto [position, is_new] = known.emplace(each.program, report.programs.size());
            if (is_new) report.programs.push_back({.program = each.program, .page = page_name(each.program)});
            each.position = report.programs[position->second].cases.size();
            report.programs[position->second].cases.push_back(i);
        }
        for (const ProgramCases& program : report.programs) select_details(report, program);
    }

    /// Failing cases get details first.
    static void select_details(NightlyReport& report, const ProgramCases& program) {
        std::size_t selected_count = 0;
        for (const bool is_clean : {false, true}) {
            for (const std::size_t position : program.cases) {
                Case& of = report.cases[position];
                if (of.now->is_clean() != is_clean || selected_count == kMaxDetails) continue;
                of.has_details = true;
                ++selected_count;
            }
        }
    }

    Database& results_;
    std::optional<Statement> run_;
    std::unordered_map<std::string, std::size_t> positions_;
    std::unordered_map<std::int64_t, std::size_t> case_by_run_;
};

}  // namespace

Result<NightlyReport> read_nightly_report(Database& results, std::int64_t since) {
    return NightlyReportReader(results).read(since);
}

}  // namespace gsim::batch
