#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/plan/plan.h"

namespace gsim::batch {

/// Batch that a cluster runs in parts, in a folder visible to all its computers, RESULTS.slurm: the plan, the
/// jobs of each shard, a file of results for each shard, the output of tasks.
struct Shards {
    std::string results;                      ///< File that all of it comes into.
    std::int64_t batch = 0;                   ///< There.
    std::string token = {};                   ///< Its token.
    std::uint64_t jobs = 0;                   ///< Jobs of the batch, including earlier runs.
    std::vector<std::uint64_t> pending_jobs;  ///< Numbers of the jobs that are run.
    std::uint64_t shards = 0;
    std::uint64_t workers = 1;  ///< For each task.
    std::uint64_t memory_mb = 4096;
    double timeout_s = 600;
    std::string array_job;   ///< Slurm's number; empty: it is not submitted.
    std::string gather_job;  ///< Job that gathers all results afterwards.
    bool gathered = false;   ///< All of it is in the results.
    bool ended = false;      ///< It was cancelled, or could not be submitted: what it lacks will not come.

    /// Returns the jobs of a shard.
    std::vector<std::uint64_t> shard_jobs(std::uint64_t shard) const;
};

std::filesystem::path shard_folder(const std::string& results);
std::filesystem::path shard_file(const std::filesystem::path& folder, std::uint64_t shard);

/// Returns the number of shards for so many jobs: of `each` jobs, but no more shards than the cluster takes
/// in an array.
std::uint64_t shard_count(std::uint64_t jobs, std::uint64_t each, std::uint64_t max);

/// Writes the files of a folder (the next functions read them). The errors are messages.
Result<void> write_shards(const std::filesystem::path& folder, const Shards& shards);
Result<Shards> read_shards(const std::filesystem::path& folder);
Result<void> write_stored_plan(const std::filesystem::path& folder, const Plan& plan);
Result<Plan> read_stored_plan(const std::filesystem::path& folder);

}  // namespace gsim::batch
