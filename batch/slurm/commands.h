#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace gsim::batch {

/// Limits of a cluster and one of its partitions.
struct ClusterLimits {
    std::string partition;                        ///< Its name.
    std::uint64_t max_array_tasks = 0;            ///< Max tasks of a job array.
    std::optional<std::uint64_t> time_min = {};   ///< Max for a job; empty: no limit.
    std::optional<std::uint64_t> memory_mb = {};  ///< Memory of its largest node.
    std::uint64_t nodes = 0;
};

/// Queries the cluster by scontrol and sinfo; an empty name: the default partition.
Result<ClusterLimits> query_limits(const std::string& partition);

/// Reads a time in Slurm's format, "2-12:30:00", "90" (minutes), "01:30:00", in minutes, rounded down; empty:
/// UNLIMITED. The error: the text is no time.
Result<std::optional<std::uint64_t>> read_minutes(std::string_view text);

/// Returns the values of a line as scontrol prints it, NAME=VALUE separated by blanks, or NAME = VALUE on
/// lines.
std::map<std::string, std::string> read_fields(std::string_view text);

/// Submits a job by sbatch; returns its number.
Result<std::string> submit_job(const std::vector<std::string>& options, const std::string& script);

/// Returns the states ("RUNNING", "PENDING"; "HELD": waiting for its release) of a job's tasks in the queue,
/// by their array indices. A task without an index is -1. Empty if the job is gone.
Result<std::map<std::int64_t, std::string>> queued_tasks(const std::string& job);

/// Cancels jobs, running or waiting.
Result<void> cancel_jobs(const std::vector<std::string>& jobs);

}  // namespace gsim::batch
