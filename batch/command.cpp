#include "batch/command.h"

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "base/os/input_file.h"
#include "base/os/installation.h"
#include "base/os/output_file.h"
#include "base/text/printable.h"
#include "batch/arguments.h"
#include "batch/optimise.h"
#include "batch/pages/pages.h"
#include "batch/run/batch_run.h"
#include "batch/run/known_runs.h"
#include "batch/slurm/cluster_batch.h"
#include "batch/slurm/waiting.h"
#include "batch/statistics/study.h"
#include "batch/stopping.h"
#include "batch/store/outputs.h"
#include "batch/store/results.h"
#include "batch/work/worker.h"
#include "batch/write_text.h"
#include "cli/exit_status.h"
#include "cli/help_text.h"
#include "cli/named_files.h"
#include "cli/own_pages.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/usage_error.h"
#include "engine/system/picture.h"

namespace gsim::batch {

namespace {

using Done = tl::expected<void, std::string>;

constexpr const char* kName = "gsim-batch";

bool is_plan(const Arguments& arguments) {
    return arguments.inputs.size() == 1 && arguments.inputs.front().ends_with(".toml");
}

tl::expected<Plan, std::string> plan_of_words(const Arguments& arguments) {
    Plan plan;
    for (const std::string& input : arguments.inputs) {
        const auto found = find_programs(input);
        if (!found) return tl::unexpected(found.error());
        add_programs(plan, *found);
    }
    if (!arguments.machines.empty()) plan.machines = arguments.machines;
    if (!arguments.machine_data.empty()) plan.options["machine_data"] = arguments.machine_data;
    if (!arguments.cell.empty()) plan.options["cell"] = arguments.cell;
    if (!arguments.dialect.empty()) plan.options["dialect"] = arguments.dialect;
    if (arguments.no_collisions) plan.options["collisions"] = false;
    return plan;
}

tl::expected<Plan, std::string> plan_of_file(const Arguments& arguments) {
    const bool says_more = !arguments.machines.empty() || !arguments.machine_data.empty() ||
                           !arguments.cell.empty() || !arguments.dialect.empty() || arguments.no_collisions;
    if (says_more)
        return tl::unexpected<std::string>(
            "a plan says itself which machines and options there are; take those away");
    return os::read_text_file(arguments.inputs.front(), os::NamedBy::command_line)
        .and_then([&](const std::string& text) { return read_plan(text, arguments.inputs.front()); });
}

tl::expected<Plan, std::string> plan_of(const Arguments& arguments) {
    auto plan = is_plan(arguments) ? plan_of_file(arguments) : plan_of_words(arguments);
    if (!plan) return plan;
    plan->keeps.report = plan->keeps.report || arguments.reports;
    plan->keeps.picture = plan->keeps.picture || arguments.pictures;
    // Without gnuplot each run would be useless.
    if (plan->keeps.picture) {
        if (const auto found = engine::find_gnuplot(); !found) return tl::unexpected(found.error());
    }
    return plan;
}

std::string shown_time(double time_s) {
    const auto whole = static_cast<std::uint64_t>(time_s);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

/// Prints the progress line, which is redrawn on a terminal.
void show_progress(const BatchTally& tally) {
    const double rate_1_s = static_cast<double>(tally.ran) / std::max(tally.wall_s, 1e-9);
    const auto left = static_cast<double>(tally.jobs - tally.done());
    const std::string rest = tally.ran > 0 ? shown_time(left / rate_1_s) + " left" : std::string();
    apps::tell(fmt::format("\r{} of {}, {} failed, {:.1f}/s, {}   ", tally.done(), tally.jobs, tally.failed,
                           rate_1_s, rest));
}

Done write_output(Database& results, const std::string& file,
                  const std::function<SqlDone(Database&, const Sink&)>& write) {
    if (file.empty()) return {};
    if (file == os::kStandardStream) {
        return write(results, [](std::string_view text) {
            apps::print(text);
            return true;
        });
    }
    auto output = os::OutputFile::open(file);
    if (!output) return tl::unexpected(output.error());
    return write(results, [&](std::string_view text) { return output->write(text); }).and_then([&] {
        return output->commit();
    });
}

Done write_statistics(const Arguments& arguments, Database& results) {
    if (!arguments.statistics && arguments.statistics_json.empty() && arguments.page.empty()) return {};
    const auto studies = read_studies(results);
    if (!studies) return tl::unexpected(studies.error());
    auto comparisons = compare_machines(results);
    if (!comparisons) return tl::unexpected(comparisons.error());
    if (arguments.since) {
        // The first batch has no predecessor, which is no reason to report nothing.
        auto before = compare_batches(results, static_cast<std::int64_t>(*arguments.since));
        if (before) {
            comparisons->push_back(*std::move(before));
        } else {
            apps::tell_fault(kName, before.error());
        }
    }
    if (arguments.statistics) {
        for (const Study& study : *studies) apps::print(text::printable(to_text(study)));
        for (const Comparison& comparison : *comparisons) apps::print(text::printable(to_text(comparison)));
    }
    return write_text(arguments.statistics_json, to_json(*studies, *comparisons)).and_then([&] {
        return write_text(arguments.page, to_html(*studies, *comparisons));
    });
}

Done write_pages_of(const Arguments& arguments, Database& results) {
    if (arguments.pages.empty()) return {};
    PagesOptions options{.folder = arguments.pages,
                         .since = static_cast<std::int64_t>(arguments.since.value_or(0))};
    if (arguments.views)
        options.views = {.program = (os::program_folder() / "gsim").string(),
                         .version = KnownRuns().version()};
    return write_pages(results, options);
}

Done write_outputs(const Arguments& arguments) {
    bring_up_to_date(arguments.results);
    auto results = Database::open(arguments.results, true);
    if (!results) return tl::unexpected(results.error());
    const auto csv = [](Database& from, const Sink& sink) { return write_csv(from, kPlainRuns, sink); };
    const auto lines = [](Database& from, const Sink& sink) {
        return write_json_lines(from, kWholeRuns, sink);
    };
    const bool prints = arguments.csv == "-" || arguments.json_lines == "-" || arguments.junit == "-" ||
                        arguments.sarif == "-" || arguments.statistics_json == "-" || arguments.page == "-";
    return write_output(*results, arguments.csv, csv)
        .and_then([&] { return write_output(*results, arguments.json_lines, lines); })
        .and_then([&] { return write_output(*results, arguments.junit, write_junit); })
        .and_then([&] { return write_output(*results, arguments.sarif, write_sarif); })
        .and_then([&] { return write_statistics(arguments, *results); })
        .and_then([&] { return write_pages_of(arguments, *results); })
        .and_then([&]() -> Done {
            if (arguments.quiet || prints || arguments.statistics) return {};
            return summary(*results).map([](const std::string& text) { apps::print(text::printable(text)); });
        });
}

int refuse(const std::string& why) {
    return apps::usage_error(kName, why);
}

int run_plan(const Arguments& arguments) {
    if (const std::string why = why_not_here(arguments.results); !why.empty()) return refuse(why);
    const auto plan = plan_of(arguments);
    if (!plan) return refuse(plan.error());
    stop_on_signals();
    const bool shows = !arguments.quiet && ::isatty(STDERR_FILENO) == 1;
    const auto tally = run_batch(*plan, arguments.batch_options(), stop_flag(), [&](const BatchTally& now) {
        if (shows) show_progress(now);
    });
    if (shows) apps::tell("\n");
    if (!tally) return refuse(tally.error());
    if (!arguments.quiet)
        apps::tell(fmt::format("{} of {} jobs: {} run in {:.2f} s, {} there already; {} failed\n",
                               tally->done(), tally->jobs, tally->ran, tally->wall_s, tally->reused,
                               tally->failed));
    if (tally->undrawn > 0)
        apps::tell_fault(
            kName, fmt::format("{} pictures could not be drawn: {}", tally->undrawn, tally->why_undrawn));
    if (const Done done = write_outputs(arguments); !done) return refuse(done.error());
    if (!tally->whole) {
        apps::tell_fault(kName, "cut off; the same command goes on from here");
        return apps::kProgramFault;
    }
    return tally->failed > 0 ? apps::kProgramFault : apps::kDone;
}

int told(const tl::expected<ClusterState, std::string>& state) {
    if (!state) return refuse(state.error());
    apps::print(to_text(*state) + '\n');
    const bool lacks = state->lost > 0 || (state->is_over() && !state->gathered);
    return lacks ? apps::kProgramFault : apps::kDone;
}

/// Returns true if runs of the latest batch have failed.
bool has_failed(const std::string& file) {
    auto results = Database::open(file, true);
    if (!results) return true;
    auto failed = results->prepare("SELECT count(*) FROM failed");
    return !failed || !failed->step().value_or(false) || failed->whole(0) > 0;
}

int submit_plan(const Arguments& arguments) {
    const auto plan = plan_of(arguments);
    if (!plan) return refuse(plan.error());
    auto state = submit(*plan, arguments.cluster_options());
    if (!state) return refuse(state.error());
    if (state->shards > 0) {
        if (!arguments.wait) return told(state);
        stop_on_signals();
        state = wait_until_over(arguments.results, stop_flag(), std::chrono::seconds(2));
    }
    const int status = told(state);
    if (!state) return status;
    if (const Done done = write_outputs(arguments); !done) return refuse(done.error());
    return status == apps::kDone && has_failed(arguments.results) ? apps::kProgramFault : status;
}

/// Runs a task that a cluster has started this program for; empty result: a user has started it.
std::optional<int> run_task(const std::vector<std::string>& words) {
    if (words.size() == 2 && words.front() == kWorkerWord) return work(std::stoull(words.back()));
    const auto ended = [](const tl::expected<bool, std::string>& whole) {
        if (!whole) return refuse(whole.error());
        return *whole ? apps::kDone : apps::kProgramFault;
    };
    if (words.size() == 3 && words.front() == kShardWord) {
        stop_when_ended();
        return ended(run_shard(words[1], std::stoull(words[2]), stop_flag()));
    }
    if (words.size() == 2 && words.front() == kGatherWord) {
        return ended(gather(words[1]).map([](const Gathered& gathered) {
            for (const std::string& fault : gathered.faults) refuse(fault);
            return gathered.whole;
        }));
    }
    return std::nullopt;
}

}  // namespace

int run_command(const std::string& called, const std::vector<std::string>& words) {
    if (const auto status = run_task(words)) return *status;
    if (called == kOptimise) return optimise(words);
    Arguments arguments;
    apps::CommandLine line(
        kName,
        "Runs many programs on many machines in many variants, and keeps what comes of it in one file");
    add_options(line, arguments);
    const std::vector<std::string> others{"gsim", "gsim-run", "gsim-check", kOptimise};
    if (const auto printed = apps::print_own_pages(line, words, others)) return *printed;
    const auto parsed = apps::parse(line, words);
    if (!parsed) return refuse(parsed.error());
    if (*parsed) return **parsed;
    if (const auto conflict = apps::find_file_conflict(line)) return refuse(*conflict);
    if (arguments.views && arguments.pages.empty()) return refuse("--views goes with --pages");
    if (arguments.status) return told(ask_state(arguments.results));
    if (arguments.cancel) return told(cancel(arguments.results));
    if (!arguments.inputs.empty()) return arguments.slurm ? submit_plan(arguments) : run_plan(arguments);
    if (arguments.slurm || !arguments.machines.empty() || arguments.retry)
        return refuse("name a plan or programs; --slurm, --machine and --retry are of them");
    const Done done = write_outputs(arguments);
    return done ? apps::kDone : refuse(done.error());
}

}  // namespace gsim::batch
