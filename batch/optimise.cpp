// gsim-optimise: finds the best values of variable settings by many runs.

#include "batch/optimise.h"

#include <chrono>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "base/os/input_file.h"
#include "base/os/output_file.h"
#include "base/text/printable.h"
#include "batch/run_arguments.h"
#include "batch/search/search.h"
#include "batch/search/search_output.h"
#include "batch/search/verification_run.h"
#include "batch/slurm/cluster_wait.h"
#include "batch/stop_signals.h"
#include "batch/write_text.h"
#include "cli/command_line.h"
#include "cli/exit_status.h"
#include "cli/named_files.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/standalone_pages.h"
#include "cli/usage_error.h"

namespace gsim::batch {

namespace {

// Other programs may use the same results during a search of hours.
constexpr std::chrono::milliseconds kLockTimeout(600'000);

struct OptimiseArguments : RunArguments {
    OptimiseArguments() {
        results = "gsim-optimise.sqlite";
        shard_runs = 10;  // as few are tried at once
    }

    std::string plan;
    std::string best, json, page;
    std::uint64_t variants = 0, seed = 0;
    bool overwrite = false;
    bool quiet = false;
};

void add_search_options(apps::CommandLine& line, OptimiseArguments& a) {
    using apps::FileKind;
    line.add("plan.toml", &a.plan, "plan: settings that may change, objective, and limits")
        .takes_file(FileKind::input, {".toml"});
    line.begin_group("Results");
    line.add("--results", &a.results, "file of all runs (SQLite): runs that it contains are not repeated")
        .takes_file(FileKind::changed, {".sqlite"})
        .with_value_name("FILE")
        .show_default();
    line.add("--best", &a.best,
             "folder for the files of the best variant, which are used for the verification run")
        .with_value_name("FOLDER")
        .takes_file(FileKind::folder);
    line.add("--overwrite", &a.overwrite, "files of --best may replace existing files");
    line.add("--json", &a.json, "write the result as JSON; -: standard output")
        .takes_file(FileKind::output, {".json"});
    line.add("--page", &a.page,
             "write the result as one HTML page with a picture of all variants; -: standard output")
        .takes_file(FileKind::output, {".html"});
    line.add("-q,--quiet", &a.quiet, "no progress");
    line.begin_group("Search");
    line.add("--variants", &a.variants, "max number of variants; 0: as in the plan").within(0, 10'000'000);
    line.add("--seed", &a.seed, "seed of the random numbers; 0: as in the plan").within(0, 10'000'000);
    line.begin_group("On this computer");
    add_worker_options(line, a);
    line.begin_group("On a cluster (Slurm)");
    add_cluster_options(line, a,
                        "submit each set of variants as an array, wait for its results, and continue");
    line.add_example("gsim-optimise place.toml --best best --page place.html",
                     "the best variant, with its files");
    line.add_example("gsim-optimise place.toml --variants 1000", "the same search continues");
    line.add_example("sqlite3 gsim-optimise.sqlite 'SELECT * FROM evaluations'", "all evaluated variants");
}

int report_search_error(const std::string& message) {
    return apps::usage_error(kOptimiseName, message);
}

Result<SearchPlan> read_search_plan(const OptimiseArguments& a) {
    return os::read_text_file(a.plan, os::NameSource::command_line)
        .and_then([&](const std::string& text) { return read_search(text, a.plan); })
        .map([&](SearchPlan search) {
            if (a.variants > 0) search.variants = a.variants;
            if (a.seed > 0) search.seed = a.seed;
            return search;
        });
}

Result<EvaluatedBatch> evaluate_locally(const OptimiseArguments& a, const Plan& plan, bool rerun) {
    BatchOptions options = a.batch_options();
    options.rerun = rerun;
    options.lock_timeout = kLockTimeout;
    return run_batch(plan, options, stop_flag(), [](const BatchTally&) {}).map([](const BatchTally& tally) {
        return EvaluatedBatch{tally.batch, tally.complete};
    });
}

/// Evaluates a plan on a cluster. Lost jobs are submitted again.
Result<EvaluatedBatch> evaluate_on_cluster(const OptimiseArguments& a, const Plan& plan, bool rerun) {
    constexpr int kMaxAttempts = 5;
    constexpr std::chrono::milliseconds kPollInterval(500);
    if (!cluster_in_use_error(a.results).empty()) {
        if (const auto over = wait_until_ended(a.results, stop_flag(), kPollInterval); !over)
            return Unexpected(over.error());
    }
    for (int attempts = 0; attempts < kMaxAttempts && !stop_flag(); ++attempts) {
        ClusterOptions options = a.cluster_options();
        options.rerun = rerun && attempts == 0;  // what was lost alone is submitted again
        auto state = submit(plan, options);
        if (state && state->shards > 0) state = wait_until_ended(a.results, stop_flag(), kPollInterval);
        if (!state) return Unexpected(state.error());
        if (state->gathered) return EvaluatedBatch{state->batch, true};
    }
    if (stop_flag()) return EvaluatedBatch{};
    return Unexpected(
        fmt::format("the cluster has lost runs {} times; see gsim-batch --results '{}' --status",
                    kMaxAttempts, a.results));
}

void print_search_progress(const SearchPlan& search, const SearchState& state, bool is_terminal) {
    const auto format_value = [](std::optional<double> value) {
        return value ? fmt::format("{:.6g}", *value) : std::string("-");
    };
    apps::print_to_standard_error(
        fmt::format("{}{} of {} variants, {} without errors; best {}, start {}{}", is_terminal ? "\r" : "",
                    state.trials, search.variants + 1, state.feasible, format_value(state.best.score.value),
                    format_value(state.start.score.value), is_terminal ? "   " : "\n"));
}

Result<void> write_search_result(const OptimiseArguments& a, const SearchPlan& search,
                                 const SearchState& state,
                                 const std::optional<VerificationRun>& verification_run) {
    const bool uses_standard_output = a.json == os::kStandardStream || a.page == os::kStandardStream;
    if (!uses_standard_output) apps::print(text::printable(to_text(search, state, verification_run)));
    if (Result<void> done = write_text(a.json, to_json(search, state, verification_run)); !done) return done;
    if (a.page.empty()) return {};
    auto results = Database::open(a.results, true);
    if (!results) return Unexpected(results.error());
    return to_html(search, state, verification_run, *results).and_then([&](const std::string& page) {
        return write_text(a.page, page);
    });
}

/// Finds useless outputs before the search, because users must not wait hours for that error.
std::optional<Error> find_output_error(const OptimiseArguments& a, const Plan& plan) {
    for (const std::string& file : {a.json, a.page}) {
        if (file.empty() || file == os::kStandardStream) continue;
        if (const auto writable = os::OutputFile::check(file); !writable) return writable.error();
    }
    return a.best.empty() ? std::nullopt : find_output_folder_error(plan, a.best, a.overwrite);
}

/// Reports the result of the search, even if its verification run fails.
int finish_search(const OptimiseArguments& a, const SearchPlan& search, const SearchState& state,
                  const Evaluate& evaluate) {
    std::optional<VerificationRun> verification_run;
    std::string verification_error;
    if (state.complete && state.best.score.is_feasible()) {
        auto verified = verify_best(search, state, a.results, a.best, evaluate);
        if (!verified) {
            verification_error = verified.error().message;
        } else {
            verification_run = *std::move(verified);
        }
    }
    if (const Result<void> done = write_search_result(a, search, state, verification_run); !done)
        return report_search_error(done.error().message);
    if (!verification_error.empty()) apps::report_error(kOptimiseName, "not verified: " + verification_error);
    if (!state.complete)
        apps::report_error(kOptimiseName, "interrupted; the same command continues from here");
    return verification_run ? apps::kSuccess : apps::kProgramError;
}

int run_search(const OptimiseArguments& a) {
    const auto search = read_search_plan(a);
    if (!search) return report_search_error(search.error().message);
    for (const std::string& warning : search->warnings)
        apps::report_error(kOptimiseName, "warning: " + warning);
    if (!a.slurm) {
        if (const std::string message = cluster_in_use_error(a.results); !message.empty())
            return report_search_error(message);
    }
    if (const auto output_error = find_output_error(a, search->plan))
        return report_search_error(output_error->message);
    stop_on_signals();
    const Evaluate evaluate = [&](const Plan& plan, bool rerun) {
        return a.slurm ? evaluate_on_cluster(a, plan, rerun) : evaluate_locally(a, plan, rerun);
    };
    const bool is_terminal = ::isatty(STDERR_FILENO) == 1;
    const auto state = search_best(*search, a.results, evaluate, [&](const SearchState& now) {
        if (!a.quiet) print_search_progress(*search, now, is_terminal);
    });
    if (is_terminal && !a.quiet) apps::print_to_standard_error("\n");
    if (!state) return report_search_error(state.error().message);
    if (state->trials == 0) {
        apps::report_error(kOptimiseName, "interrupted before the first run");
        return apps::kProgramError;
    }
    return finish_search(a, *search, *state, evaluate);
}

}  // namespace

int optimise(const std::vector<std::string>& words) {
    OptimiseArguments arguments;
    apps::CommandLine line(kOptimiseName,
                           "Searches for the settings with which programs are fastest, or best by another "
                           "criterion, without errors");
    add_search_options(line, arguments);
    const std::vector<std::string> others{"gsim", "gsim-batch", "gsim-run"};
    if (const auto printed = apps::print_standalone_pages(line, words, others)) return *printed;
    const auto parsed = apps::parse(line, words);
    if (!parsed) return report_search_error(parsed.error().message);
    if (*parsed) return **parsed;
    if (const auto conflict = apps::find_file_conflict(line)) return report_search_error(conflict->message);
    if (arguments.plan.empty()) return report_search_error("name a plan (docs/optimise.md)");
    return run_search(arguments);
}

}  // namespace gsim::batch
