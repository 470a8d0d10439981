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
#include "batch/run/run_cache.h"
#include "batch/slurm/cluster_batch.h"
#include "batch/slurm/cluster_wait.h"
#include "batch/statistics/study.h"
#include "batch/stop_signals.h"
#include "batch/store/outputs.h"
#include "batch/store/results.h"
#include "batch/work/worker.h"
#include "batch/write_text.h"
#include "cli/exit_status.h"
#include "cli/help_text.h"
#include "cli/named_files.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/standalone_pages.h"
#include "cli/usage_error.h"
#include "engine/system/picture.h"

namespace gsim::batch {

namespace {

constexpr const char* kName = "gsim-batch";

bool is_plan_file(const Arguments& arguments) {
    return arguments.inputs.size() == 1 && arguments.inputs.front().ends_with(".toml");
}

Result<Plan> plan_from_options(const Arguments& arguments) {
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

Result<Plan> plan_from_file(const Arguments& arguments) {
    const bool has_other_options = !arguments.machines.empty() || !arguments.machine_data.empty() ||
                                   !arguments.cell.empty() || !arguments.dialect.empty() ||
                                   arguments.no_collisions;
    if (has_other_options)
        return Unexpected("a plan defines the machines and options; remove the other options");
    return os::read_text_file(arguments.inputs.front(), os::NameSource::command_line)
        .and_then([&](const std::string& text) { return read_plan(text, arguments.inputs.front()); });
}

Result<Plan> make_plan(const Arguments& arguments) {
    auto plan = is_plan_file(arguments) ? plan_from_file(arguments) : plan_from_options(arguments);
    if (!plan) return plan;
    plan->stored_documents.report = plan->stored_documents.report || arguments.reports;
    plan->stored_documents.picture = plan->stored_documents.picture || arguments.pictures;
    // Without gnuplot each run would be useless.
    if (plan->stored_documents.picture) {
        if (const auto found = engine::find_gnuplot(); !found) return tl::unexpected(found.error());
    }
    return plan;
}

std::string format_time(double time_s) {
    const auto complete = static_cast<std::uint64_t>(time_s);
    return fmt::format("{}:{:02}:{:02}", complete / 3600, complete / 60 % 60, complete % 60);
}

/// Prints the progress line, which is redrawn on a terminal.
void print_progress(const BatchTally& tally) {
    const double runs_per_s = static_cast<double>(tally.ran) / std::max(tally.wall_time_s, 1e-9);
    const auto remaining = static_cast<double>(tally.jobs - tally.done());
    const std::string remaining_time =
        tally.ran > 0 ? format_time(remaining / runs_per_s) + " left" : std::string();
    apps::print_to_standard_error(fmt::format("\r{} of {}, {} failed, {:.1f}/s, {}   ", tally.done(),
                                              tally.jobs, tally.failed, runs_per_s, remaining_time));
}

Result<void> write_output(Database& results, const std::string& file,
                          const std::function<Result<void>(Database&, const Sink&)>& write) {
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

Result<void> write_statistics(const Arguments& arguments, Database& results) {
    if (!arguments.outputs.statistics && arguments.outputs.statistics_json.empty() &&
        arguments.outputs.page.empty())
        return {};
    const auto studies = read_studies(results);
    if (!studies) return tl::unexpected(studies.error());
    auto comparisons = compare_machines(results);
    if (!comparisons) return tl::unexpected(comparisons.error());
    if (arguments.outputs.since) {
        // The first batch has no predecessor, which is no reason to report nothing.
        auto before = compare_batches(results, static_cast<std::int64_t>(*arguments.outputs.since));
        if (before) {
            comparisons->push_back(*std::move(before));
        } else {
            apps::report_error(kName, before.error().message);
        }
    }
    if (arguments.outputs.statistics) {
        for (const Study& study : *studies) apps::print(text::printable(to_text(study)));
        for (const Comparison& comparison : *comparisons) apps::print(text::printable(to_text(comparison)));
    }
    return write_text(arguments.outputs.statistics_json, to_json(*studies, *comparisons)).and_then([&] {
        return write_text(arguments.outputs.page, to_html(*studies, *comparisons));
    });
}

Result<void> write_report_pages(const Arguments& arguments, Database& results) {
    if (arguments.outputs.pages.empty()) return {};
    PagesOptions options{.folder = arguments.outputs.pages,
                         .since = static_cast<std::int64_t>(arguments.outputs.since.value_or(0))};
    if (arguments.outputs.views)
        options.views = {.program = (os::program_folder() / "gsim").string(),
                         .version = RunCache().version()};
    return write_pages(results, options);
}

Result<void> write_outputs(const Arguments& arguments) {
    upgrade_schema(arguments.results);
    auto results = Database::open(arguments.results, true);
    if (!results) return tl::unexpected(results.error());
    const auto csv = [](Database& from, const Sink& sink) {
        return write_csv(from, kTableColumnsQuery, sink);
    };
    const auto lines = [](Database& from, const Sink& sink) {
        return write_json_lines(from, kAllColumnsQuery, sink);
    };
    const bool uses_standard_output = arguments.outputs.csv == "-" || arguments.outputs.json_lines == "-" ||
                                      arguments.outputs.junit == "-" || arguments.outputs.sarif == "-" ||
                                      arguments.outputs.statistics_json == "-" ||
                                      arguments.outputs.page == "-";
    return write_output(*results, arguments.outputs.csv, csv)
        .and_then([&] { return write_output(*results, arguments.outputs.json_lines, lines); })
        .and_then([&] { return write_output(*results, arguments.outputs.junit, write_junit); })
        .and_then([&] { return write_output(*results, arguments.outputs.sarif, write_sarif); })
        .and_then([&] { return write_statistics(arguments, *results); })
        .and_then([&] { return write_report_pages(arguments, *results); })
        .and_then([&]() -> Result<void> {
            if (arguments.quiet || uses_standard_output || arguments.outputs.statistics) return {};
            return summary(*results).map([](const std::string& text) { apps::print(text::printable(text)); });
        });
}

int report_usage_error(const std::string& message) {
    return apps::usage_error(kName, message);
}

int run_plan(const Arguments& arguments) {
    if (const std::string message = cluster_in_use_error(arguments.results); !message.empty())
        return report_usage_error(message);
    const auto plan = make_plan(arguments);
    if (!plan) return report_usage_error(plan.error().message);
    stop_on_signals();
    const bool is_shown = !arguments.quiet && ::isatty(STDERR_FILENO) == 1;
    const auto tally = run_batch(*plan, arguments.batch_options(), stop_flag(), [&](const BatchTally& now) {
        if (is_shown) print_progress(now);
    });
    if (is_shown) apps::print_to_standard_error("\n");
    if (!tally) return report_usage_error(tally.error().message);
    if (!arguments.quiet)
        apps::print_to_standard_error(fmt::format("{} of {} jobs: {} run in {:.2f} s, {} reused; {} failed\n",
                                                  tally->done(), tally->jobs, tally->ran, tally->wall_time_s,
                                                  tally->reused, tally->failed));
    if (tally->missing_pictures > 0)
        apps::report_error(kName, fmt::format("{} pictures could not be drawn: {}", tally->missing_pictures,
                                              tally->first_picture_error));
    if (const Result<void> done = write_outputs(arguments); !done)
        return report_usage_error(done.error().message);
    if (!tally->complete) {
        apps::report_error(kName, "interrupted; the same command continues from here");
        return apps::kProgramError;
    }
    return tally->failed > 0 ? apps::kProgramError : apps::kSuccess;
}

int report_status(const Result<ClusterState>& state) {
    if (!state) return report_usage_error(state.error().message);
    apps::print(to_text(*state) + '\n');
    const bool is_incomplete = state->lost > 0 || (state->has_ended() && !state->gathered);
    return is_incomplete ? apps::kProgramError : apps::kSuccess;
}

/// Returns true if runs of the latest batch have failed.
bool has_failed_runs(const std::string& file) {
    auto results = Database::open(file, true);
    if (!results) return true;
    auto failed = results->prepare("SELECT count(*) FROM failed");
    return !failed || !failed->step().value_or(false) || failed->integer(0) > 0;
}

int submit_plan(const Arguments& arguments) {
    const auto plan = make_plan(arguments);
    if (!plan) return report_usage_error(plan.error().message);
    auto state = submit(*plan, arguments.cluster_options());
    if (!state) return report_usage_error(state.error().message);
    if (state->shards > 0) {
        if (!arguments.cluster.wait) return report_status(state);
        stop_on_signals();
        state = wait_until_ended(arguments.results, stop_flag(), std::chrono::seconds(2));
    }
    const int status = report_status(state);
    if (!state) return status;
    if (const Result<void> done = write_outputs(arguments); !done)
        return report_usage_error(done.error().message);
    return status == apps::kSuccess && has_failed_runs(arguments.results) ? apps::kProgramError : status;
}

/// Runs a task that a cluster has started this program for; empty result: a user has started it.
std::optional<int> run_task(const std::vector<std::string>& words) {
    if (words.size() == 2 && words.front() == kWorkerOption) return run_worker(std::stoull(words.back()));
    const auto ended = [](const Result<bool>& complete) {
        if (!complete) return report_usage_error(complete.error().message);
        return *complete ? apps::kSuccess : apps::kProgramError;
    };
    if (words.size() == 3 && words.front() == kShardOption) {
        stop_on_sigterm();
        return ended(run_shard(words[1], std::stoull(words[2]), stop_flag()));
    }
    if (words.size() == 2 && words.front() == kGatherOption) {
        return ended(gather(words[1]).map([](const GatherResult& gathered) {
            for (const std::string& shard_error : gathered.errors) report_usage_error(shard_error);
            return gathered.complete;
        }));
    }
    return std::nullopt;
}

}  // namespace

int run_command(const std::string& program_name, const std::vector<std::string>& words) {
    if (const auto status = run_task(words)) return *status;
    if (program_name == kOptimiseName) return optimise(words);
    Arguments arguments;
    apps::CommandLine line(
        kName, "Runs many programs on many machines in many variants, and stores the results in one file");
    add_options(line, arguments);
    const std::vector<std::string> others{"gsim", "gsim-run", "gsim-check", kOptimiseName};
    if (const auto printed = apps::print_standalone_pages(line, words, others)) return *printed;
    const auto parsed = apps::parse(line, words);
    if (!parsed) return report_usage_error(parsed.error().message);
    if (*parsed) return **parsed;
    if (const auto conflict = apps::find_file_conflict(line)) return report_usage_error(conflict->message);
    if (arguments.outputs.views && arguments.outputs.pages.empty())
        return report_usage_error("--views requires --pages");
    if (arguments.cluster.status) return report_status(query_state(arguments.results));
    if (arguments.cluster.cancel) return report_status(cancel(arguments.results));
    if (!arguments.inputs.empty()) return arguments.slurm ? submit_plan(arguments) : run_plan(arguments);
    if (arguments.slurm || !arguments.machines.empty() || arguments.retry)
        return report_usage_error("name a plan or programs; --slurm, --machine and --retry require one");
    const Result<void> done = write_outputs(arguments);
    return done ? apps::kSuccess : report_usage_error(done.error().message);
}

}  // namespace gsim::batch
