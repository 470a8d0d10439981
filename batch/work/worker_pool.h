#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "base/error.h"
#include "base/os/descriptor.h"
#include "batch/work/job.h"
#include "batch/work/run_row.h"

namespace gsim::batch {

/// Options for running jobs.
struct PoolOptions {
    std::vector<std::string> command;  ///< Begins a worker.
    std::size_t workers = 1;
    double timeout_s = 600;  ///< For a job, by the clock; then its worker is killed.
};

/// Pool of processes that run jobs. If one crashes, or takes too long or too much memory, only the row of its
/// job is lost: another process replaces it.
class WorkerPool {
  public:
    explicit WorkerPool(PoolOptions options);
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;
    /// Kills the workers that are still active.
    ~WorkerPool();

    /// Returns true if the pool can take a job that will soon be begun.
    bool has_capacity() const;
    /// Adds a job. The error: no process can be started.
    Result<void> submit(Job job);
    /// Returns the number of jobs without a row.
    std::size_t pending_count() const;
    /// Waits at most so long for rows, and returns them.
    Result<std::vector<RunRow>> collect(std::chrono::milliseconds max_wait);

  private:
    using Clock = std::chrono::steady_clock;

    struct QueuedJob {
        Job job;
        int killed_attempts = 0;  ///< That somebody from outside has ended.
    };
    struct Worker {
        pid_t child;
        os::Descriptor input;             ///< Jobs go there.
        os::Descriptor output;            ///< Rows come from there.
        std::deque<QueuedJob> jobs = {};  ///< The one in front is run.
        Clock::time_point start = {};
        std::string unsent_text = {};
        std::string received = {};
        bool timed_out = false;
        bool has_finished_job = false;  ///< It has run a job to its end.
    };

    Result<void> enqueue(QueuedJob queued);
    Result<void> start_worker();
    static void send(Worker& worker);
    /// Reads available output; returns false at the end of the output.
    bool receive(Worker& worker, std::vector<RunRow>& rows);
    Result<void> remove_ended_worker(std::list<Worker>::iterator worker, std::vector<RunRow>& rows);
    void kill_if_timed_out(Worker& worker) const;
    std::chrono::milliseconds time_until_timeout(std::chrono::milliseconds max_duration) const;

    PoolOptions options_;
    std::list<Worker> workers_;
};

}  // namespace gsim::batch
