#include "batch/slurm/cluster_batch.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

#include "base/os/file_lock.h"
#include "base/os/output_file.h"
#include "batch/run/batch_run.h"
#include "batch/run/known_runs.h"
#include "batch/run/own_program.h"
#include "batch/slurm/commands.h"
#include "batch/slurm/shards.h"
#include "batch/store/results.h"
#include "batch/work/run_commands.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using Fault = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;

constexpr std::uint64_t kShardMemory_mb = 4096;
constexpr std::chrono::milliseconds kClusterLockWait(60'000);
constexpr int kCancelWait_s = 60;

/// Memory below which a node's value is ignored: Slurm reports such a value if it is not configured.
constexpr std::uint64_t kLeastNode_mb = 256;
/// Memory of a task in addition to its workers.
constexpr std::uint64_t kOwn_mb = 128;

/// Iterates over all jobs: those that were run before belong to the batch at once.
tl::expected<Shards, std::string> find_todo(const Plan& plan, const ClusterOptions& options) {
    auto lock = os::FileLock::get(options.results, std::chrono::milliseconds(0));
    if (!lock) return Fault(lock.error());
    auto results = Results::open(options.results, Journal::rollback);
    if (!results) return Fault(results.error());
    KnownRuns known;
    const Jobs jobs(plan);
    Shards shards;
    shards.results = options.results;
    shards.jobs = jobs.size();
    if (const auto begun = results->begin_batch(plan.name, jobs.size(), known.version()); !begun)
        return Fault(begun.error());
    shards.batch = results->batch();
    shards.token = results->token();
    for (std::uint64_t number = 0; number < jobs.size(); ++number) {
        const Job job = jobs.job(number);
        using Found = tl::expected<std::optional<Results::FoundRun>, std::string>;
        const Found found =
            options.anew ? Found() : known.find(*results, known.key_of(job), job, options.retry);
        if (!found) return Fault(found.error());
        if (!*found) {
            shards.todo.push_back(number);
        } else if (const auto noted = results->note(number, (*found)->run, true); !noted) {
            return Fault(noted.error());
        }
    }
    if (const auto ended = results->end_batch(shards.todo.empty()); !ended) return Fault(ended.error());
    return shards;
}

Done check_limits(const ClusterOptions& options, const ClusterLimits& limits) {
    if (limits.time_min && options.time_limit_min > *limits.time_min)
        return Fault(fmt::format("partition '{}' allows {} minutes; {} are asked for (--time-limit)",
                                 limits.partition, *limits.time_min, options.time_limit_min));
    const std::uint64_t memory_mb = options.memory_mb.value_or(0) * options.workers;
    if (limits.memory_mb.value_or(0) >= kLeastNode_mb && memory_mb + kOwn_mb > *limits.memory_mb)
        return Fault(
            fmt::format("the largest node of partition '{}' has {} MB; {} workers of {} MB are asked for",
                        limits.partition, *limits.memory_mb, options.workers, *options.memory_mb));
    return {};
}

std::uint64_t memory_for(const ClusterOptions& options, const ClusterLimits& limits) {
    if (options.memory_mb) return *options.memory_mb;
    if (!limits.memory_mb || *limits.memory_mb < kLeastNode_mb) return kShardMemory_mb;
    return std::clamp<std::uint64_t>((*limits.memory_mb - kOwn_mb) / options.workers, 64, kShardMemory_mb);
}

Done write_script(const fs::path& file, const std::string& words) {
    Done done =
        os::write_file(file, fmt::format("#!/bin/sh\nexec {} {}\n", shell_word(own_program()), words));
    std::error_code error;
    if (done) fs::permissions(file, fs::perms::owner_all, error);
    if (error) return Fault(fmt::format("'{}': {}", file.string(), error.message()));
    return done;
}

Done write_folder(const fs::path& folder, const Plan& plan, const Shards& shards) {
    std::error_code error;
    fs::remove_all(folder, error);
    fs::create_directories(folder, error);
    if (error) return Fault(fmt::format("'{}': {}", folder.string(), error.message()));
    const std::string place = shell_word(folder.string());
    return write_plan_of(folder, plan)
        .and_then([&] { return write_shards(folder, shards); })
        .and_then([&] {
            return write_script(folder / "task.sh",
                                fmt::format("{} {} \"$SLURM_ARRAY_TASK_ID\"", kShardWord, place));
        })
        .and_then(
            [&] { return write_script(folder / "gather.sh", fmt::format("{} {}", kGatherWord, place)); });
}

Done submit_jobs(const fs::path& folder, const ClusterOptions& options, const ClusterLimits& limits,
                 Shards& shards) {
    const std::string here = "--chdir=" + fs::current_path().string();
    const std::vector<std::string> common{"--partition=" + limits.partition, here, "--requeue",
                                          "--open-mode=append", "--ntasks=1"};
    std::vector<std::string> array = common;
    array.push_back(fmt::format("--array=0-{}", shards.shards - 1));
    array.push_back("--job-name=gsim-batch");
    array.push_back("--output=" + (folder / "task-%a.log").string());
    array.push_back(fmt::format("--cpus-per-task={}", options.workers));
    if (limits.memory_mb.value_or(0) >= kLeastNode_mb)
        array.push_back(fmt::format("--mem-per-cpu={}M", shards.memory_mb + kOwn_mb / options.workers));
    if (options.time_limit_min > 0) array.push_back(fmt::format("--time={}", options.time_limit_min));
    auto job = submit_job(array, (folder / "task.sh").string());
    if (!job) return Fault(job.error());
    shards.array_job = *std::move(job);
    if (Done written = write_shards(folder, shards); !written) return written;
    std::vector<std::string> behind = common;
    behind.push_back("--job-name=gsim-gather");
    behind.push_back("--output=" + (folder / "gather.log").string());
    behind.push_back("--dependency=afterany:" + shards.array_job);
    auto gathers = submit_job(behind, (folder / "gather.sh").string());
    if (!gathers) {
        static_cast<void>(cancel_jobs({shards.array_job}));
        return Fault(gathers.error());
    }
    shards.gather_job = *std::move(gathers);
    return write_shards(folder, shards);
}

/// Returns the number of jobs that have a run in the file of a shard.
std::uint64_t rows_in(const fs::path& file) {
    if (!fs::exists(file)) return 0;
    auto results = Database::open(file.string(), true);
    if (!results) return 0;
    auto count = results->prepare("SELECT count(DISTINCT job) FROM batch_run");
    if (!count || !count->step().value_or(false)) return 0;
    return static_cast<std::uint64_t>(count->whole(0));
}

void count_queued(const std::string& state, ClusterState& counted) {
    const bool held = state == "HELD";
    counted.held += held ? 1 : 0;
    ++(held || state == "PENDING" || state == "REQUEUED" ? counted.waiting : counted.running);
}

tl::expected<ClusterState, std::string> state_of_shards(const fs::path& folder, const Shards& shards) {
    ClusterState state{.array_job = shards.array_job, .gather_job = shards.gather_job};
    state.batch = shards.batch;
    state.jobs = shards.jobs;
    state.reused = shards.jobs - shards.todo.size();
    state.shards = shards.shards;
    state.gathered = shards.gathered;
    std::map<std::int64_t, std::string> queued;
    for (const std::string& job : {shards.array_job, shards.gather_job}) {
        if (job.empty()) continue;
        auto tasks = queued_tasks(job);
        if (!tasks) return Fault(tasks.error());
        queued.merge(*tasks);
    }
    const auto is_queued = [&](std::int64_t place) { return queued.contains(place); };
    for (std::uint64_t shard = 0; shard < shards.shards; ++shard) {
        const std::uint64_t wanted = shards.jobs_of(shard).size();
        const std::uint64_t ran = shards.gathered ? 0 : rows_in(shard_file(folder, shard));
        state.ran += ran;
        const auto place = static_cast<std::int64_t>(shard);
        if (is_queued(place)) {
            count_queued(queued[place], state);
        } else if (shards.gathered || ran == wanted) {
            ++state.whole;
        } else {
            ++state.lost;
        }
    }
    if (is_queued(-1)) count_queued(queued[-1], state);
    return state;
}

tl::expected<Shards, std::string> submitted_shards(const fs::path& folder, const std::string& results) {
    return read_shards(folder).map_error([&](const std::string& why) {
        return fmt::format("no batch of '{}' was submitted: {}", results, why);
    });
}

/// Removes the files of an earlier submission, so that it is not run again.
Done clear_earlier(const fs::path& folder) {
    if (!fs::exists(folder / "shards.json")) return {};
    const auto shards = read_shards(folder);
    if (!shards) return Fault(shards.error());
    const auto state = state_of_shards(folder, *shards);
    if (!state) return Fault(state.error());
    if (!state->is_over())
        return Fault(fmt::format("a batch of '{}' is under way: {}; --status tells more, --cancel ends it",
                                 shards->results, to_text(*state)));
    if (shards->gathered) return {};
    const auto gathered = gather(folder.string());
    if (!gathered)
        return Fault(fmt::format("{}; what is there of it is in {}", gathered.error(), folder.string()));
    if (gathered->faults.empty()) return {};
    return Fault(fmt::format("{}; remove {} where that is not wanted any more", gathered->faults.front(),
                             folder.string()));
}

}  // namespace

tl::expected<ClusterState, std::string> submit(const Plan& plan, const ClusterOptions& asked) {
    ClusterOptions options = asked;
    options.results = fs::absolute(asked.results).string();
    const fs::path folder = folder_of(options.results);
    if (const Done cleared = clear_earlier(folder); !cleared) return Fault(cleared.error());
    const auto limits = ask_limits(options.partition);
    if (!limits) return Fault(limits.error());
    if (const Done good = check_limits(options, *limits); !good) return Fault(good.error());
    auto shards = find_todo(plan, options);
    if (!shards) return Fault(shards.error());
    if (shards->todo.empty()) {
        ClusterState state;
        state.batch = shards->batch;
        state.jobs = state.reused = shards->jobs;
        state.gathered = true;
        return state;
    }
    shards->shards = shard_count(shards->todo.size(), options.shard_runs, limits->array_tasks);
    shards->workers = options.workers;
    shards->memory_mb = memory_for(options, *limits);
    shards->timeout_s = options.timeout_s;
    if (const Done written = write_folder(folder, plan, *shards); !written) return Fault(written.error());
    if (const Done submitted = submit_jobs(folder, options, *limits, *shards); !submitted) {
        shards->ended = true;
        static_cast<void>(write_shards(folder, *shards));
        return Fault(submitted.error());
    }
    return state_of_shards(folder, *shards);
}

std::string why_not_here(const std::string& results) {
    const fs::path folder = folder_of(fs::absolute(results).string());
    if (!fs::exists(folder / "shards.json")) return {};
    const auto shards = read_shards(folder);
    if (shards && (shards->gathered || shards->ended)) return {};
    return fmt::format(
        "'{}' belongs to a batch on a cluster that is not gathered; --status tells of it, --cancel ends it, "
        "and "
        "--slurm submits what it has lost",
        results);
}

tl::expected<ClusterState, std::string> ask_state(const std::string& results) {
    const fs::path folder = folder_of(fs::absolute(results).string());
    const auto shards = submitted_shards(folder, results);
    if (!shards) return Fault(shards.error());
    return state_of_shards(folder, *shards);
}

std::string to_text(const ClusterState& state) {
    std::string text = fmt::format("{} runs, {} there before", state.jobs, state.reused);
    if (state.shards == 0) return text + "; nothing is to be run";
    text += fmt::format("; {} shards (job {}): {} whole, {} running, {} waiting, {} lost", state.shards,
                        state.array_job, state.whole, state.running, state.waiting, state.lost);
    if (state.held > 0)
        text += fmt::format("; {} are held until somebody releases them (scontrol release)", state.held);
    return text + (state.gathered ? "; gathered" : fmt::format("; {} have a row", state.ran));
}

tl::expected<ClusterState, std::string> cancel(const std::string& results) {
    const fs::path folder = folder_of(fs::absolute(results).string());
    const auto shards = submitted_shards(folder, results);
    if (!shards) return Fault(shards.error());
    if (const auto cancelled = cancel_jobs({shards->gather_job, shards->array_job}); !cancelled)
        return Fault(cancelled.error());
    // Tasks complete the runs that are in progress.
    for (int waited_s = 0; waited_s < kCancelWait_s; ++waited_s) {
        const auto state = state_of_shards(folder, *shards);
        if (state && state->is_over()) break;
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }
    const auto gathered = gather(folder.string());
    if (!gathered) return Fault(gathered.error());
    auto ended = read_shards(folder);
    if (!ended) return Fault(ended.error());
    ended->ended = true;
    if (const Done written = write_shards(folder, *ended); !written) return Fault(written.error());
    if (!gathered->faults.empty()) return Fault(gathered->faults.front());
    return ask_state(results);
}

tl::expected<bool, std::string> run_shard(const std::string& folder, std::uint64_t shard,
                                          const std::atomic<bool>& stop) {
    const auto shards = read_shards(folder);
    if (!shards) return Fault(shards.error());
    const auto plan = read_plan_of(folder);
    if (!plan) return Fault(plan.error());
    if (shard >= shards->shards) return Fault(fmt::format("there are {} shards", shards->shards));
    const auto tally = run_batch(*plan,
                                 {.results = shard_file(folder, shard).string(),
                                  .workers = shards->workers,
                                  .memory_mb = shards->memory_mb,
                                  .timeout_s = shards->timeout_s,
                                  .journal = Journal::rollback,
                                  .only = shards->jobs_of(shard)},
                                 stop, [](const BatchTally&) {});
    if (!tally) return Fault(tally.error());
    return tally->whole;
}

tl::expected<Gathered, std::string> gather(const std::string& folder) {
    auto shards = read_shards(folder);
    if (!shards) return Fault(shards.error());
    auto lock = os::FileLock::get(shards->results, kClusterLockWait);
    if (!lock) return Fault(lock.error());
    auto results = Results::open(shards->results, Journal::rollback);
    if (!results) return Fault(results.error());
    if (const auto resumed = results->resume_batch(shards->batch, shards->token); !resumed)
        return Fault(resumed.error());
    Gathered gathered;
    for (std::uint64_t shard = 0; shard < shards->shards; ++shard) {
        const fs::path file = shard_file(folder, shard);
        if (!fs::exists(file)) continue;
        if (const auto taken = results->take_over(file.string()); !taken)
            gathered.faults.push_back(fmt::format("{}: {}", file.string(), taken.error()));
    }
    const auto noted = results->noted();
    if (!noted) return Fault(noted.error());
    gathered.whole = *noted == shards->jobs;
    if (const auto ended = results->end_batch(gathered.whole); !ended) return Fault(ended.error());
    shards->gathered = gathered.whole;
    if (const Done written = write_shards(folder, *shards); !written) return Fault(written.error());
    // All runs of the shard files are in the results.
    std::error_code ignored;
    for (std::uint64_t shard = 0; gathered.whole && shard < shards->shards; ++shard)
        fs::remove(shard_file(folder, shard), ignored);
    return gathered;
}

}  // namespace gsim::batch
