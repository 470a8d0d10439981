#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>

#include "batch/run/batch_run.h"
#include "batch/slurm/cluster_batch.h"
#include "cli/command_line.h"

namespace gsim::batch {

/// Options that both programs have for the location and the execution of runs.
struct RunArguments {
    std::string results;
    std::uint64_t workers = std::max(std::thread::hardware_concurrency(), 1U);
    std::optional<double> memory_mb;
    double timeout_s = 600;
    bool retry = false;
    bool slurm = false;
    std::string partition;
    std::uint64_t shard_runs = 1000, task_workers = 1, time_limit_min = 0;

    BatchOptions batch_options() const;
    ClusterOptions cluster_options() const;
};

/// Adds the options of this computer: workers and their limits.
void add_worker_options(apps::CommandLine& line, RunArguments& arguments);
/// Adds the options of a cluster; `slurm` says what is submitted.
void add_cluster_options(apps::CommandLine& line, RunArguments& arguments, const char* slurm);

}  // namespace gsim::batch
