#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"

namespace gsim::batch {

/// How a cluster is to run a plan.
struct ClusterOptions {
    std::string results;
    std::string partition = {};        ///< Empty: the cluster's default.
    std::uint64_t shard_runs = 1000;   ///< Runs of a task.
    std::uint64_t workers = 1;         ///< Processes of a task, each with a processor of its own.
    std::uint64_t time_limit_min = 0;  ///< Of a task; 0: the partition's own.
    std::optional<std::uint64_t> memory_mb =
        {};  ///< Of a worker; nothing: what a node has for each, 4096 at most.
    double timeout_s = 600;
    bool anew = false;  ///< What is there already is run all the same.
    bool retry = false;
};

/// How far a batch of a cluster is.
struct ClusterState {
    std::string array_job, gather_job;
    std::int64_t batch = 0;    ///< Its number in the results.
    std::uint64_t jobs = 0;    ///< Of the batch.
    std::uint64_t reused = 0;  ///< They were there when it was submitted.
    std::uint64_t ran = 0;     ///< In files of shards, or gathered.
    std::uint64_t shards = 0, whole = 0, running = 0, waiting = 0;
    std::uint64_t held = 0;  ///< Of those that wait: somebody has to release them.
    std::uint64_t lost = 0;  ///< Shards that are neither whole nor in the queue.
    bool gathered = false;

    bool is_over() const { return running == 0 && waiting == 0; }
};

/// Submits what of a plan has not been run yet: an array of tasks, and a job behind it that puts all
/// together. What an earlier submission has left is gathered first, so that the same command again submits
/// what was lost alone. The error is a sentence: a batch is under way, a limit of the cluster, what sbatch
/// says.
tl::expected<ClusterState, std::string> submit(const Plan& plan, const ClusterOptions& options);

/// Why nothing else may be run into a file of results: a cluster is at work for it; empty where none is.
std::string why_not_here(const std::string& results);

/// How far it is, by its files and the queue.
tl::expected<ClusterState, std::string> ask_state(const std::string& results);
/// For people.
std::string to_text(const ClusterState& state);

/// Ends all of its tasks, and gathers what there is.
tl::expected<ClusterState, std::string> cancel(const std::string& results);

/// What a task does: runs a shard, or goes on with it. Whether it is whole.
tl::expected<bool, std::string> run_shard(const std::string& folder, std::uint64_t shard,
                                          const std::atomic<bool>& stop);

struct Gathered {
    bool whole = false;                    ///< All of the batch is there.
    std::vector<std::string> faults = {};  ///< Files of shards that cannot be read, in sentences.
};
/// Puts what the shards have into the file of results; as often as one likes.
tl::expected<Gathered, std::string> gather(const std::string& folder);

/// The words that tasks call this program with, in front of the folder (and a shard's number).
inline constexpr const char* kShardWord = "--shard";
inline constexpr const char* kGatherWord = "--gather";

}  // namespace gsim::batch
