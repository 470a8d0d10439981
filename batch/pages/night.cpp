#include "batch/pages/night.h"

#include <utility>

#include <fmt/format.h>

#include "batch/pages/page_name.h"

namespace gsim::batch {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr std::int64_t kMostBatches = 90;  // of a history
constexpr std::size_t kMostDetails = 40;   // of a program's page
constexpr std::size_t kNoCase = static_cast<std::size_t>(-1);
constexpr std::string_view kBatches =
    "SELECT id, plan, version, began_at, coalesce(ended_at, ''), jobs, whole FROM batch ";
constexpr std::string_view kRun =
    "SELECT program, machine, settings, status, cause, message, file, line, cycle_time_s, violations, "
    "collisions, process_findings, warnings FROM run WHERE id = ?";

/// Reader of the results. Copies of a job have one run, so the first copy represents all.
class NightReader {
  public:
    explicit NightReader(Database& results) : results_(results) {}

    tl::expected<Night, std::string> read(std::int64_t since) {
        auto run = results_.prepare(kRun);
        if (!run) return Fault(run.error());
        run_ = *std::move(run);
        auto batches = read_batches(fmt::format("ORDER BY id DESC LIMIT {}", kMostBatches));
        if (!batches) return Fault(batches.error());
        if (batches->empty()) return Fault(fmt::format("there is no batch in '{}'", results_.file()));
        auto before = find_before(*batches, since);
        if (!before) return Fault(before.error());
        Night night(batches->front());
        night.before = *std::move(before);
        night.batches.assign(batches->rbegin(), batches->rend());
        const auto done = count_older(night).and_then([&] { return take_runs(night); }).and_then([&] {
            return take_history(night);
        });
        if (!done) return Fault(done.error());
        sort_by_program(night);
        return night;
    }

  private:
    tl::expected<std::vector<BatchFacts>, std::string> read_batches(const std::string& which) {
        auto rows = results_.prepare(fmt::format("{}{}", kBatches, which));
        if (!rows) return Fault(rows.error());
        std::vector<BatchFacts> batches;
        while (true) {
            const auto row = rows->step();
            if (!row) return Fault(row.error());
            if (!*row) return batches;
            batches.push_back({.id = rows->whole(0),
                               .plan = std::string(rows->text(1)),
                               .version = std::string(rows->text(2)),
                               .began_at = std::string(rows->text(3)),
                               .ended_at = std::string(rows->text(4)),
                               .jobs = rows->whole(5),
                               .whole = rows->whole(6) != 0});
        }
    }

    tl::expected<std::optional<BatchFacts>, std::string> find_before(const std::vector<BatchFacts>& batches,
                                                                     std::int64_t since) {
        if (since == 0) return batches.size() > 1 ? std::optional(batches[1]) : std::nullopt;
        auto found = read_batches(fmt::format("WHERE id = {}", since));
        if (!found) return Fault(found.error());
        if (found->empty() || since >= batches.front().id)
            return Fault(
                fmt::format("there is no batch {} before the latest one in '{}'", since, results_.file()));
        return found->front();
    }

    SqlDone count_older(Night& night) {
        auto count = results_.prepare("SELECT count(*) FROM batch");
        if (!count) return Fault(count.error());
        const auto row = count->step();
        if (!row) return Fault(row.error());
        night.older_batches = count->whole(0) - static_cast<std::int64_t>(night.batches.size());
        return {};
    }

    SqlDone take_runs(Night& night) {
        const auto now = [&](std::size_t place, const RunFacts& run, bool reused) {
            Case& of = night.cases[place];
            if (of.now == nullptr) of.is_reused = reused;
            if (of.now == nullptr) of.now = &run;
        };
        const auto before = [&](std::size_t place, const RunFacts& run, bool) {
            Case& of = night.cases[place];
            if (of.before == nullptr) of.before = &run;
        };
        auto taken = for_each_run(night, night.latest, true, now);
        if (!taken || !night.before) return taken;
        return for_each_run(night, *night.before, true, before);
    }

    SqlDone take_history(Night& night) {
        for (std::size_t i = 0; i < night.batches.size(); ++i) {
            auto taken = for_each_run(night, night.batches[i], false,
                                      [&](std::size_t place, const RunFacts& run, bool) {
                                          auto& history = night.cases[place].history;
                                          if (history.empty() || history.back().batch != i)
                                              history.push_back({i, &run});
                                      });
            if (!taken) return taken;
        }
        return {};
    }

    /// Calls `take` with case and run of each job of a batch. Unknown cases are added or left out.
    template <typename Take>
    SqlDone for_each_run(Night& night, BatchFacts& batch, bool adds_cases, const Take& take) {
        auto rows = results_.prepare("SELECT run, reused FROM batch_run WHERE batch = ? ORDER BY job");
        if (!rows) return Fault(rows.error());
        rows->bind(1, batch.id);
        batch.runs = batch.failed = batch.reused = 0;
        while (true) {
            const auto row = rows->step();
            if (!row) return Fault(row.error());
            if (!*row) return {};
            const std::int64_t id = rows->whole(0);
            const bool reused = rows->whole(1) != 0;
            const auto place = case_of(night, id, adds_cases);
            if (!place) return Fault(place.error());
            const RunFacts& run = night.runs.at(id);
            ++batch.runs;
            batch.failed += run.is_clean() ? 0 : 1;
            batch.reused += reused ? 1 : 0;
            if (*place != kNoCase) take(*place, run, reused);
        }
    }

    /// Returns the case index. A run is read once, for any number of batches.
    tl::expected<std::size_t, std::string> case_of(Night& night, std::int64_t id, bool adds) {
        if (const auto known = case_of_run_.find(id); known != case_of_run_.end()) return known->second;
        run_->bind(1, id);
        const auto row = run_->step();
        if (!row || !*row)
            return Fault(row ? fmt::format("run {} is not in '{}'", id, results_.file()) : row.error());
        const auto text = [&](int column) { return std::string(run_->text(column)); };
        night.runs[id] = {.id = id,
                          .status = text(3),
                          .cause = text(4),
                          .message = text(5),
                          .file = text(6),
                          .line = run_->whole(7),
                          .time_s = run_->number(8),
                          .violations = run_->whole(9),
                          .collisions = run_->whole(10),
                          .process_findings = run_->whole(11),
                          .warnings = run_->whole(12)};
        Case of{.program = text(0), .machine = text(1), .settings = text(2)};
        if (const auto read = run_->run(); !read) return Fault(read.error());
        return case_of_run_[id] = place_of(night, std::move(of), adds);
    }

    std::size_t place_of(Night& night, Case of, bool adds) {
        const std::string key = of.program + '\0' + of.machine + '\0' + of.settings;
        if (const auto known = places_.find(key); known != places_.end()) return known->second;
        if (!adds) return kNoCase;
        night.cases.push_back(std::move(of));
        return places_[key] = night.cases.size() - 1;
    }

    static void sort_by_program(Night& night) {
        std::unordered_map<std::string, std::size_t> known;
        for (std::size_t i = 0; i < night.cases.size(); ++i) {
            Case& each = night.cases[i];
            if (each.now == nullptr) continue;
            const auto [place, is_new] = known.emplace(each.program, night.programs.size());
            if (is_new) night.programs.push_back({.program = each.program, .page = page_name(each.program)});
            each.place = night.programs[place->second].cases.size();
            night.programs[place->second].cases.push_back(i);
        }
        for (const ProgramCases& program : night.programs) choose_details(night, program);
    }

    /// Failing cases get details first.
    static void choose_details(Night& night, const ProgramCases& program) {
        std::size_t chosen = 0;
        for (const bool is_clean : {false, true}) {
            for (const std::size_t place : program.cases) {
                Case& of = night.cases[place];
                if (of.now->is_clean() != is_clean || chosen == kMostDetails) continue;
                of.has_details = true;
                ++chosen;
            }
        }
    }

    Database& results_;
    std::optional<Statement> run_;
    std::unordered_map<std::string, std::size_t> places_;
    std::unordered_map<std::int64_t, std::size_t> case_of_run_;
};

}  // namespace

tl::expected<Night, std::string> read_night(Database& results, std::int64_t since) {
    return NightReader(results).read(since);
}

}  // namespace gsim::batch
