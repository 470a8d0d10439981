#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::batch {

/// What a cluster and one of its partitions allow.
struct ClusterLimits {
    std::string partition;                        ///< Its name.
    std::uint64_t array_tasks = 0;                ///< Of a job array, at most.
    std::optional<std::uint64_t> time_min = {};   ///< Of a job, at most; nothing: no limit.
    std::optional<std::uint64_t> memory_mb = {};  ///< Of its largest node.
    std::uint64_t nodes = 0;
};

/// Asks the cluster by scontrol and sinfo; an empty name: the default partition. The error is a sentence.
tl::expected<ClusterLimits, std::string> ask_limits(const std::string& partition);

/// Slurm's way to write a time, "2-12:30:00", "90" (minutes), "01:30:00", in minutes, rounded down; nothing:
/// UNLIMITED. The error: it is none.
tl::expected<std::optional<std::uint64_t>, std::string> read_minutes(std::string_view text);

/// Values of a line as scontrol prints it, NAME=VALUE with blanks between, or NAME = VALUE on lines.
std::map<std::string, std::string> read_fields(std::string_view text);

/// Submits a job by sbatch; its number.
tl::expected<std::string, std::string> submit_job(const std::vector<std::string>& options,
                                                  const std::string& script);

/// States ("RUNNING", "PENDING"; "HELD": waiting until somebody releases it) of the tasks of a job that are
/// in the queue, by their places in the array. A task without a place is -1. None where the job is gone.
tl::expected<std::map<std::int64_t, std::string>, std::string> queued_tasks(const std::string& job);

/// Ends jobs, running or waiting.
tl::expected<void, std::string> cancel_jobs(const std::vector<std::string>& jobs);

}  // namespace gsim::batch
