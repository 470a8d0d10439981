#include "batch/run_arguments.h"

namespace gsim::batch {

namespace {

constexpr std::uint64_t kDefaultMemory_mb = 4096;

}  // namespace

BatchOptions RunArguments::batch_options() const {
    BatchOptions options;
    options.results = results;
    options.workers = workers;
    options.memory_mb = memory_mb ? static_cast<std::uint64_t>(*memory_mb) : kDefaultMemory_mb;
    options.timeout_s = timeout_s;
    options.retry = retry;
    return options;
}

ClusterOptions RunArguments::cluster_options() const {
    ClusterOptions options;
    options.results = results;
    options.partition = partition;
    options.shard_runs = shard_runs;
    options.workers = task_workers;
    options.time_limit_min = time_limit_min;
    options.timeout_s = timeout_s;
    options.retry = retry;
    if (memory_mb) options.memory_mb = static_cast<std::uint64_t>(*memory_mb);
    return options;
}

void add_worker_options(apps::CommandLine& line, RunArguments& a) {
    line.add("-j,--workers", &a.workers, "number of processes that run programs in parallel")
        .within(1, 4096)
        .show_default();
    line.add("--memory-mb", &a.memory_mb, "max memory of a worker; only the run that exceeds it fails")
        .with_value_name("MB")
        .within(64, 1'000'000)
        .describe_default("4096; on a cluster at most the memory of its nodes");
    line.add("--timeout", &a.timeout_s, "max wall-clock time of a run")
        .with_value_name("SECONDS")
        .within(0.01, 1e6)
        .show_default();
    line.add("--retry", &a.retry, "repeat runs that crashed, or exceeded the limit of time or memory");
}

void add_cluster_options(apps::CommandLine& line, RunArguments& a, const char* slurm) {
    line.add("--slurm", &a.slurm, slurm);
    line.add("--partition", &a.partition,
             "partition of the cluster; default: the cluster's default partition")
        .with_value_name("NAME");
    line.add("--shard-runs", &a.shard_runs, "runs per task").within(1, 10'000'000).show_default();
    line.add("--task-workers", &a.task_workers, "processes, and processors, per task")
        .within(1, 1024)
        .show_default();
    line.add("--time-limit", &a.time_limit_min, "max time of a task; default: that of the partition")
        .with_value_name("MINUTES");
}

}  // namespace gsim::batch
