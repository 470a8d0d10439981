#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/plan/plan.h"

namespace gsim::batch {

/// Options for running a plan on a cluster.
struct ClusterOptions {
    std::string results;
    std::string partition = {};        ///< Empty: the cluster's default.
    std::uint64_t shard_runs = 1000;   ///< Runs of a task.
    std::uint64_t workers = 1;         ///< Processes of a task, each on a separate processor.
    std::uint64_t time_limit_min = 0;  ///< For a task; 0: the partition's default.
    std::optional<std::uint64_t> memory_mb =
        {};  ///< For a worker; empty: the node's share for each, 4096 at most.
    double timeout_s = 600;
    bool rerun = false;  ///< Repeats runs that already exist.
    bool retry = false;
};

/// Progress of a batch on a cluster.
struct ClusterState {
    std::string array_job, gather_job;
    std::int64_t batch = 0;    ///< Its number in the results.
    std::uint64_t jobs = 0;    ///< Jobs of the batch.
    std::uint64_t reused = 0;  ///< They were there when it was submitted.
    std::uint64_t ran = 0;     ///< In files of shards, or gathered.
    std::uint64_t shards = 0, complete = 0, running = 0, waiting = 0;
    std::uint64_t fixed = 0;  ///< Among those that wait: someone has to release them.
    std::uint64_t lost = 0;   ///< Shards that are neither complete nor in the queue.
    bool gathered = false;

    bool has_ended() const { return running == 0 && waiting == 0; }
};

/// Submits the jobs of a plan that have not been run yet: an array of tasks, followed by a job that collects
/// the results. Results of an earlier submission are gathered first, so that the same command again submits
/// only lost jobs. The error is a message: a batch in progress, a limit of the cluster, or the output of
/// sbatch.
Result<ClusterState> submit(const Plan& plan, const ClusterOptions& options);

/// Returns a message why no other program may run into a file of results: a cluster works on it. Empty if
/// none does.
std::string cluster_in_use_error(const std::string& results);

/// Queries the progress by the files and the queue.
Result<ClusterState> query_state(const std::string& results);
/// Returns a text for people.
std::string to_text(const ClusterState& state);

/// Ends all tasks, and gathers the existing results.
Result<ClusterState> cancel(const std::string& results);

/// Runs a shard, or continues it, as the work of a task. Returns true if it is complete.
Result<bool> run_shard(const std::string& folder, std::uint64_t shard, const std::atomic<bool>& stop);

struct GatherResult {
    bool complete = false;                 ///< All of the batch is there.
    std::vector<std::string> errors = {};  ///< Messages about files of shards that cannot be read.
};
/// Copies the results of the shards into the file of results; may be repeated.
Result<GatherResult> gather(const std::string& folder);

/// Words with which tasks call this program, in front of the folder (and a shard's number).
inline constexpr const char* kShardOption = "--shard";
inline constexpr const char* kGatherOption = "--gather";

}  // namespace gsim::batch
