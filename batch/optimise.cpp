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
#include "batch/search/proof.h"
#include "batch/search/search.h"
#include "batch/search/search_output.h"
#include "batch/slurm/waiting.h"
#include "batch/stopping.h"
#include "batch/write_text.h"
#include "cli/command_line.h"
#include "cli/exit_status.h"
#include "cli/named_files.h"
#include "cli/own_pages.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/usage_error.h"

namespace gsim::batch {

namespace {

using Done = tl::expected<void, std::string>;
using Fault = tl::unexpected<std::string>;

// Other programs may use the same results during a search of hours.
constexpr std::chrono::milliseconds kLockWait(600'000);

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
    line.add("plan.toml", &a.plan, "what may change, what counts, and which limits are to be kept")
        .of_file(FileKind::input, {".toml"});
    line.begin_group("Results");
    line.add("--results", &a.results, "file of all runs (SQLite): what is in it is not run again")
        .of_file(FileKind::changed, {".sqlite"})
        .called("FILE")
        .shows_default();
    line.add("--best", &a.best, "folder for the files of the best variant, from which it is run once more")
        .called("FOLDER")
        .of_file(FileKind::folder);
    line.add("--overwrite", &a.overwrite, "files of --best may replace files that are there already");
    line.add("--json", &a.json, "write what was found as JSON; -: standard output")
        .of_file(FileKind::output, {".json"});
    line.add("--page", &a.page, "write it as one HTML page with a picture of all trials; -: standard output")
        .of_file(FileKind::output, {".html"});
    line.add("-q,--quiet", &a.quiet, "no progress");
    line.begin_group("Search");
    line.add("--variants", &a.variants, "how many are tried at most; 0: as the plan says")
        .within(0, 10'000'000);
    line.add("--seed", &a.seed, "of what is drawn by lot; 0: as the plan says").within(0, 10'000'000);
    line.begin_group("Here");
    add_worker_options(line, a);
    line.begin_group("On a cluster (Slurm)");
    add_cluster_options(
        line, a,
        "submit the variants that are tried at once as an array, wait until it is gathered, and go on");
    line.add_example("gsim-optimise place.toml --best best --page place.html", "the best, with its files");
    line.add_example("gsim-optimise place.toml --variants 1000", "the same search goes on");
    line.add_example("sqlite3 gsim-optimise.sqlite 'SELECT * FROM evaluations'", "all that was tried");
}

int refuse_search(const std::string& why) {
    return apps::usage_error(kOptimise, why);
}

tl::expected<SearchPlan, std::string> search_of(const OptimiseArguments& a) {
    return os::read_text_file(a.plan, os::NamedBy::command_line)
        .and_then([&](const std::string& text) { return read_search(text, a.plan); })
        .map([&](SearchPlan search) {
            if (a.variants > 0) search.variants = a.variants;
            if (a.seed > 0) search.seed = a.seed;
            return search;
        });
}

tl::expected<Evaluated, std::string> evaluate_here(const OptimiseArguments& a, const Plan& plan, bool anew) {
    BatchOptions options = a.batch_options();
    options.anew = anew;
    options.lock_wait = kLockWait;
    return run_batch(plan, options, stop_flag(), [](const BatchTally&) {}).map([](const BatchTally& tally) {
        return Evaluated{tally.batch, tally.whole};
    });
}

/// Evaluates a plan on a cluster. Lost jobs are submitted again.
tl::expected<Evaluated, std::string> evaluate_on_cluster(const OptimiseArguments& a, const Plan& plan,
                                                         bool anew) {
    constexpr int kMostTries = 5;
    constexpr std::chrono::milliseconds kPoll(500);
    if (!why_not_here(a.results).empty()) {
        if (const auto over = wait_until_over(a.results, stop_flag(), kPoll); !over)
            return Fault(over.error());
    }
    for (int tries = 0; tries < kMostTries && !stop_flag(); ++tries) {
        ClusterOptions options = a.cluster_options();
        options.anew = anew && tries == 0;  // what was lost alone is submitted again
        auto state = submit(plan, options);
        if (state && state->shards > 0) state = wait_until_over(a.results, stop_flag(), kPoll);
        if (!state) return Fault(state.error());
        if (state->gathered) return Evaluated{state->batch, true};
    }
    if (stop_flag()) return Evaluated{};
    return Fault(
        fmt::format("the cluster has lost runs {} times; gsim-batch --results '{}' --status tells more",
                    kMostTries, a.results));
}

void show_search(const SearchPlan& search, const SearchState& state, bool on_terminal) {
    const auto shown = [](std::optional<double> value) {
        return value ? fmt::format("{:.6g}", *value) : std::string("-");
    };
    apps::tell(fmt::format("{}{} of {} variants, {} without a fault; best {}, start {}{}",
                           on_terminal ? "\r" : "", state.tried, search.variants + 1, state.allowed,
                           shown(state.best.score.value), shown(state.start.score.value),
                           on_terminal ? "   " : "\n"));
}

Done write_found(const OptimiseArguments& a, const SearchPlan& search, const SearchState& state,
                 const std::optional<Proof>& proof) {
    const bool prints = a.json == os::kStandardStream || a.page == os::kStandardStream;
    if (!prints) apps::print(text::printable(to_text(search, state, proof)));
    if (Done done = write_text(a.json, to_json(search, state, proof)); !done) return done;
    if (a.page.empty()) return {};
    auto results = Database::open(a.results, true);
    if (!results) return Fault(results.error());
    return to_html(search, state, proof, *results).and_then([&](const std::string& page) {
        return write_text(a.page, page);
    });
}

/// Reports useless outputs before the search, because users must not wait hours for that error.
std::string fault_of_outputs(const OptimiseArguments& a, const Plan& plan) {
    for (const std::string& file : {a.json, a.page}) {
        if (file.empty() || file == os::kStandardStream) continue;
        if (const auto writable = os::OutputFile::check(file); !writable) return writable.error();
    }
    return a.best.empty() ? std::string() : fault_of_folder(plan, a.best, a.overwrite);
}

/// Reports the result of the search, even if its verification run fails.
int conclude(const OptimiseArguments& a, const SearchPlan& search, const SearchState& state,
             const Evaluate& evaluate) {
    std::optional<Proof> proof;
    std::string why_unproven;
    if (state.whole && state.best.score.is_allowed()) {
        auto proven = prove(search, state, a.results, a.best, evaluate);
        if (!proven) {
            why_unproven = proven.error();
        } else {
            proof = *std::move(proven);
        }
    }
    if (const Done done = write_found(a, search, state, proof); !done) return refuse_search(done.error());
    if (!why_unproven.empty()) apps::tell_fault(kOptimise, "not proven: " + why_unproven);
    if (!state.whole) apps::tell_fault(kOptimise, "cut off; the same command goes on from here");
    return proof ? apps::kDone : apps::kProgramFault;
}

int run_search(const OptimiseArguments& a) {
    const auto search = search_of(a);
    if (!search) return refuse_search(search.error());
    if (!a.slurm) {
        if (const std::string why = why_not_here(a.results); !why.empty()) return refuse_search(why);
    }
    if (const std::string fault = fault_of_outputs(a, search->plan); !fault.empty())
        return refuse_search(fault);
    stop_on_signals();
    const Evaluate evaluate = [&](const Plan& plan, bool anew) {
        return a.slurm ? evaluate_on_cluster(a, plan, anew) : evaluate_here(a, plan, anew);
    };
    const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
    const auto state = search_best(*search, a.results, evaluate, [&](const SearchState& now) {
        if (!a.quiet) show_search(*search, now, on_terminal);
    });
    if (on_terminal && !a.quiet) apps::tell("\n");
    if (!state) return refuse_search(state.error());
    if (state->tried == 0) {
        apps::tell_fault(kOptimise, "cut off before anything was run");
        return apps::kProgramFault;
    }
    return conclude(a, *search, *state, evaluate);
}

}  // namespace

int optimise(const std::vector<std::string>& words) {
    OptimiseArguments arguments;
    apps::CommandLine line(
        kOptimise,
        "Looks for the values of settings for which programs are fastest, or best in another "
        "way, without a fault");
    add_search_options(line, arguments);
    const std::vector<std::string> others{"gsim", "gsim-batch", "gsim-run"};
    if (const auto printed = apps::print_own_pages(line, words, others)) return *printed;
    const auto parsed = apps::parse(line, words);
    if (!parsed) return refuse_search(parsed.error());
    if (*parsed) return **parsed;
    if (const auto conflict = apps::find_file_conflict(line)) return refuse_search(*conflict);
    if (arguments.plan.empty()) return refuse_search("name a plan (docs/optimise.md)");
    return run_search(arguments);
}

}  // namespace gsim::batch
