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
    line.add("-j,--workers", &a.workers, "processes that run programs at once")
        .within(1, 4096)
        .show_default();
    line.add("--memory-mb", &a.memory_mb, "memory that a worker may take; a run that needs more fails alone")
        .with_value_name("MB")
        .within(64, 1'000'000)
        .describe_default("4096; on a cluster no more than its nodes have");
    line.add("--timeout", &a.timeout_s, "time that a run may take, by the clock")
        .with_value_name("SECONDS")
        .within(0.01, 1e6)
        .show_default();
    line.add("--retry", &a.retry, "run again what crashed, took too long or too much memory");
}

void add_cluster_options(apps::CommandLine& line, RunArguments& a, const char* slurm) {
    line.add("--slurm", &a.slurm, slurm);
    line.add("--partition", &a.partition, "where; else the cluster's default").with_value_name("NAME");
    line.add("--shard-runs", &a.shard_runs, "runs of a task").within(1, 10'000'000).show_default();
    line.add("--task-workers", &a.task_workers, "processes, and processors, of a task")
        .within(1, 1024)
        .show_default();
    line.add("--time-limit", &a.time_limit_min, "time that a task may take; else as the partition has it")
        .with_value_name("MINUTES");
}

}  // namespace gsim::batch
