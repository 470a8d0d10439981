#include "batch/slurm/cluster_batch.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

#include "base/os/file_lock.h"
#include "base/os/output_file.h"
#include "batch/run/batch_run.h"
#include "batch/run/current_executable.h"
#include "batch/run/run_cache.h"
#include "batch/slurm/commands.h"
#include "batch/slurm/shards.h"
#include "batch/store/results.h"
#include "batch/work/run_commands.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kDefaultWorkerMemory_mb = 4096;
constexpr std::chrono::milliseconds kClusterLockTimeout(60'000);
constexpr int kCancelTimeout_s = 60;

/// Memory below which a node's value is ignored: Slurm reports such a value if it is not configured.
constexpr std::uint64_t kMinNode_mb = 256;
/// Memory of a task in addition to its workers.
constexpr std::uint64_t kTaskOverhead_mb = 128;

/// Iterates over all jobs: those that were run before belong to the batch at once.
Result<Shards> find_pending_jobs(const Plan& plan, const ClusterOptions& options) {
    auto lock = os::FileLock::get(options.results, std::chrono::milliseconds(0));
    if (!lock) return Unexpected(lock.error());
    auto results = Results::open(options.results, Journal::rollback);
    if (!results) return Unexpected(results.error());
    RunCache run_cache;
    const Jobs jobs(plan);
    Shards shards;
    shards.results = options.results;
    shards.jobs = jobs.size();
    if (const auto begun = results->begin_batch(plan.name, jobs.size(), run_cache.version()); !begun)
        return Unexpected(begun.error());
    shards.batch = results->batch();
    shards.token = results->token();
    for (std::uint64_t number = 0; number < jobs.size(); ++number) {
        const Job job = jobs.job(number);
        using LookupResult = Result<std::optional<Results::StoredRun>>;
        const LookupResult found = options.rerun
                                       ? LookupResult()
                                       : run_cache.find(*results, run_cache.run_key(job), job, options.retry);
        if (!found) return Unexpected(found.error());
        if (!*found) {
            shards.pending_jobs.push_back(number);
        } else if (const auto recorded = results->record(number, (*found)->run, true); !recorded) {
            return Unexpected(recorded.error());
        }
    }
    if (const auto ended = results->end_batch(shards.pending_jobs.empty()); !ended)
        return Unexpected(ended.error());
    return shards;
}

Result<void> check_limits(const ClusterOptions& options, const ClusterLimits& limits) {
    if (limits.time_min && options.time_limit_min > *limits.time_min)
        return Unexpected(fmt::format("partition '{}' allows {} minutes; {} are requested (--time-limit)",
                                      limits.partition, *limits.time_min, options.time_limit_min));
    const std::uint64_t memory_mb = options.memory_mb.value_or(0) * options.workers;
    if (limits.memory_mb.value_or(0) >= kMinNode_mb && memory_mb + kTaskOverhead_mb > *limits.memory_mb)
        return Unexpected(
            fmt::format("the largest node of partition '{}' has {} MB; {} workers of {} MB are requested",
                        limits.partition, *limits.memory_mb, options.workers, *options.memory_mb));
    return {};
}

std::uint64_t worker_memory_mb(const ClusterOptions& options, const ClusterLimits& limits) {
    if (options.memory_mb) return *options.memory_mb;
    if (!limits.memory_mb || *limits.memory_mb < kMinNode_mb) return kDefaultWorkerMemory_mb;
    return std::clamp<std::uint64_t>((*limits.memory_mb - kTaskOverhead_mb) / options.workers, 64,
                                     kDefaultWorkerMemory_mb);
}

Result<void> write_script(const fs::path& file, const std::string& words) {
    Result<void> done =
        os::write_file(file, fmt::format("#!/bin/sh\nexec {} {}\n", shell_word(current_executable()), words));
    std::error_code error;
    if (done) fs::permissions(file, fs::perms::owner_all, error);
    if (error) return Unexpected(fmt::format("'{}': {}", file.string(), error.message()));
    return done;
}

Result<void> write_folder(const fs::path& folder, const Plan& plan, const Shards& shards) {
    std::error_code error;
    fs::remove_all(folder, error);
    fs::create_directories(folder, error);
    if (error) return Unexpected(fmt::format("'{}': {}", folder.string(), error.message()));
    const std::string quoted_folder = shell_word(folder.string());
    return write_stored_plan(folder, plan)
        .and_then([&] { return write_shards(folder, shards); })
        .and_then([&] {
            return write_script(folder / "task.sh",
                                fmt::format("{} {} \"$SLURM_ARRAY_TASK_ID\"", kShardOption, quoted_folder));
        })
        .and_then([&] {
            return write_script(folder / "gather.sh", fmt::format("{} {}", kGatherOption, quoted_folder));
        });
}

Result<void> submit_jobs(const fs::path& folder, const ClusterOptions& options, const ClusterLimits& limits,
                         Shards& shards) {
    const std::string working_folder = "--chdir=" + fs::current_path().string();
    const std::vector<std::string> common{"--partition=" + limits.partition, working_folder, "--requeue",
                                          "--open-mode=append", "--ntasks=1"};
    std::vector<std::string> array = common;
    array.push_back(fmt::format("--array=0-{}", shards.shards - 1));
    array.push_back("--job-name=gsim-batch");
    array.push_back("--output=" + (folder / "task-%a.log").string());
    array.push_back(fmt::format("--cpus-per-task={}", options.workers));
    if (limits.memory_mb.value_or(0) >= kMinNode_mb)
        array.push_back(
            fmt::format("--mem-per-cpu={}M", shards.memory_mb + kTaskOverhead_mb / options.workers));
    if (options.time_limit_min > 0) array.push_back(fmt::format("--time={}", options.time_limit_min));
    auto job = submit_job(array, (folder / "task.sh").string());
    if (!job) return Unexpected(job.error());
    shards.array_job = *std::move(job);
    if (Result<void> written = write_shards(folder, shards); !written) return written;
    std::vector<std::string> gather_options = common;
    gather_options.push_back("--job-name=gsim-gather");
    gather_options.push_back("--output=" + (folder / "gather.log").string());
    gather_options.push_back("--dependency=afterany:" + shards.array_job);
    auto gather_job_id = submit_job(gather_options, (folder / "gather.sh").string());
    if (!gather_job_id) {
        static_cast<void>(cancel_jobs({shards.array_job}));
        return Unexpected(gather_job_id.error());
    }
    shards.gather_job = *std::move(gather_job_id);
    return write_shards(folder, shards);
}

/// Returns the number of jobs that have a run in the file of a shard.
std::uint64_t count_rows(const fs::path& file) {
    if (!fs::exists(file)) return 0;
    auto results = Database::open(file.string(), true);
    if (!results) return 0;
    auto count = results->prepare("SELECT count(DISTINCT job) FROM batch_run");
    if (!count || !count->step().value_or(false)) return 0;
    return static_cast<std::uint64_t>(count->integer(0));
}

void count_queued(const std::string& state, ClusterState& count_text) {
    const bool fixed = state == "HELD";
    count_text.fixed += fixed ? 1 : 0;
    ++(fixed || state == "PENDING" || state == "REQUEUED" ? count_text.waiting : count_text.running);
}

Result<ClusterState> query_shards(const fs::path& folder, const Shards& shards) {
    ClusterState state{.array_job = shards.array_job, .gather_job = shards.gather_job};
    state.batch = shards.batch;
    state.jobs = shards.jobs;
    state.reused = shards.jobs - shards.pending_jobs.size();
    state.shards = shards.shards;
    state.gathered = shards.gathered;
    std::map<std::int64_t, std::string> queued;
    for (const std::string& job : {shards.array_job, shards.gather_job}) {
        if (job.empty()) continue;
        auto tasks = queued_tasks(job);
        if (!tasks) return Unexpected(tasks.error());
        queued.merge(*tasks);
    }
    const auto is_queued = [&](std::int64_t quoted_folder) { return queued.contains(quoted_folder); };
    for (std::uint64_t shard = 0; shard < shards.shards; ++shard) {
        const std::uint64_t expected_runs = shards.shard_jobs(shard).size();
        const std::uint64_t ran = shards.gathered ? 0 : count_rows(shard_file(folder, shard));
        state.ran += ran;
        const auto quoted_folder = static_cast<std::int64_t>(shard);
        if (is_queued(quoted_folder)) {
            count_queued(queued[quoted_folder], state);
        } else if (shards.gathered || ran == expected_runs) {
            ++state.complete;
        } else {
            ++state.lost;
        }
    }
    if (is_queued(-1)) count_queued(queued[-1], state);
    return state;
}

Result<Shards> read_submitted_shards(const fs::path& folder, const std::string& results) {
    return read_shards(folder).map_error([&](const Error& error) {
        return Error(fmt::format("no batch of '{}' was submitted: {}", results, error.message));
    });
}

/// Removes the files of an earlier submission, so that it is not run again.
Result<void> clear_earlier_batch(const fs::path& folder) {
    if (!fs::exists(folder / "shards.json")) return {};
    const auto shards = read_shards(folder);
    if (!shards) return Unexpected(shards.error());
    const auto state = query_shards(folder, *shards);
    if (!state) return Unexpected(state.error());
    if (!state->has_ended())
        return Unexpected(
            fmt::format("a batch of '{}' is running: {}; --status shows its state, --cancel cancels it",
                        shards->results, to_text(*state)));
    if (shards->gathered) return {};
    const auto gathered = gather(folder.string());
    if (!gathered)
        return Unexpected(
            fmt::format("{}; the available results are in {}", gathered.error().message, folder.string()));
    if (gathered->errors.empty()) return {};
    return Unexpected(
        fmt::format("{}; remove {} if it is no longer needed", gathered->errors.front(), folder.string()));
}

}  // namespace

Result<ClusterState> submit(const Plan& plan, const ClusterOptions& given_options) {
    ClusterOptions options = given_options;
    options.results = fs::absolute(given_options.results).string();
    const fs::path folder = shard_folder(options.results);
    if (const Result<void> cleared = clear_earlier_batch(folder); !cleared)
        return Unexpected(cleared.error());
    const auto limits = query_limits(options.partition);
    if (!limits) return Unexpected(limits.error());
    if (const Result<void> checked = check_limits(options, *limits); !checked)
        return Unexpected(checked.error());
    auto shards = find_pending_jobs(plan, options);
    if (!shards) return Unexpected(shards.error());
    if (shards->pending_jobs.empty()) {
        ClusterState state;
        state.batch = shards->batch;
        state.jobs = state.reused = shards->jobs;
        state.gathered = true;
        return state;
    }
    shards->shards = shard_count(shards->pending_jobs.size(), options.shard_runs, limits->max_array_tasks);
    shards->workers = options.workers;
    shards->memory_mb = worker_memory_mb(options, *limits);
    shards->timeout_s = options.timeout_s;
    if (const Result<void> written = write_folder(folder, plan, *shards); !written)
        return Unexpected(written.error());
    if (const Result<void> submitted = submit_jobs(folder, options, *limits, *shards); !submitted) {
        shards->ended = true;
        static_cast<void>(write_shards(folder, *shards));
        return Unexpected(submitted.error());
    }
    return query_shards(folder, *shards);
}

std::string cluster_in_use_error(const std::string& results) {
    const fs::path folder = shard_folder(fs::absolute(results).string());
    if (!fs::exists(folder / "shards.json")) return {};
    const auto shards = read_shards(folder);
    if (shards && (shards->gathered || shards->ended)) return {};
    return fmt::format(
        "'{}' belongs to a batch on a cluster that is not merged; --status shows its state, --cancel cancels "
        "it, and --slurm submits its lost runs again",
        results);
}

Result<ClusterState> query_state(const std::string& results) {
    const fs::path folder = shard_folder(fs::absolute(results).string());
    const auto shards = read_submitted_shards(folder, results);
    if (!shards) return Unexpected(shards.error());
    return query_shards(folder, *shards);
}

std::string to_text(const ClusterState& state) {
    std::string text = fmt::format("{} runs, {} reused", state.jobs, state.reused);
    if (state.shards == 0) return text + "; no runs are pending";
    text += fmt::format("; {} shards (job {}): {} complete, {} running, {} waiting, {} lost", state.shards,
                        state.array_job, state.complete, state.running, state.waiting, state.lost);
    if (state.fixed > 0)
        text += fmt::format("; {} are held until they are released (scontrol release)", state.fixed);
    return text + (state.gathered ? "; merged" : fmt::format("; {} finished", state.ran));
}

Result<ClusterState> cancel(const std::string& results) {
    const fs::path folder = shard_folder(fs::absolute(results).string());
    const auto shards = read_submitted_shards(folder, results);
    if (!shards) return Unexpected(shards.error());
    if (const auto cancelled = cancel_jobs({shards->gather_job, shards->array_job}); !cancelled)
        return Unexpected(cancelled.error());
    // Tasks complete the runs that are in progress.
    for (int waited_s = 0; waited_s < kCancelTimeout_s; ++waited_s) {
        const auto state = query_shards(folder, *shards);
        if (state && state->has_ended()) break;
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }
    const auto gathered = gather(folder.string());
    if (!gathered) return Unexpected(gathered.error());
    auto ended = read_shards(folder);
    if (!ended) return Unexpected(ended.error());
    ended->ended = true;
    if (const Result<void> written = write_shards(folder, *ended); !written)
        return Unexpected(written.error());
    if (!gathered->errors.empty()) return Unexpected(gathered->errors.front());
    return query_state(results);
}

Result<bool> run_shard(const std::string& folder, std::uint64_t shard, const std::atomic<bool>& stop) {
    const auto shards = read_shards(folder);
    if (!shards) return Unexpected(shards.error());
    const auto plan = read_stored_plan(folder);
    if (!plan) return Unexpected(plan.error());
    if (shard >= shards->shards) return Unexpected(fmt::format("the batch has {} shards", shards->shards));
    const auto tally = run_batch(*plan,
                                 {.results = shard_file(folder, shard).string(),
                                  .workers = shards->workers,
                                  .memory_mb = shards->memory_mb,
                                  .timeout_s = shards->timeout_s,
                                  .journal = Journal::rollback,
                                  .only = shards->shard_jobs(shard)},
                                 stop, [](const BatchTally&) {});
    if (!tally) return Unexpected(tally.error());
    return tally->complete;
}

Result<GatherResult> gather(const std::string& folder) {
    auto shards = read_shards(folder);
    if (!shards) return Unexpected(shards.error());
    auto lock = os::FileLock::get(shards->results, kClusterLockTimeout);
    if (!lock) return Unexpected(lock.error());
    auto results = Results::open(shards->results, Journal::rollback);
    if (!results) return Unexpected(results.error());
    if (const auto resumed = results->resume_batch(shards->batch, shards->token); !resumed)
        return Unexpected(resumed.error());
    GatherResult gathered;
    for (std::uint64_t shard = 0; shard < shards->shards; ++shard) {
        const fs::path file = shard_file(folder, shard);
        if (!fs::exists(file)) continue;
        if (const auto merge_result = results->merge(file.string()); !merge_result)
            gathered.errors.push_back(fmt::format("{}: {}", file.string(), merge_result.error().message));
    }
    const auto recorded = results->recorded();
    if (!recorded) return Unexpected(recorded.error());
    gathered.complete = *recorded == shards->jobs;
    if (const auto ended = results->end_batch(gathered.complete); !ended) return Unexpected(ended.error());
    shards->gathered = gathered.complete;
    if (const Result<void> written = write_shards(folder, *shards); !written)
        return Unexpected(written.error());
    // All runs of the shard files are in the results.
    std::error_code ignored;
    for (std::uint64_t shard = 0; gathered.complete && shard < shards->shards; ++shard)
        fs::remove(shard_file(folder, shard), ignored);
    return gathered;
}

}  // namespace gsim::batch
