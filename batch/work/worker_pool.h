#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>
#include <tl/expected.hpp>

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
    bool has_room() const;
    /// Adds a job. The error: no process can be started.
    tl::expected<void, std::string> give(Job job);
    /// Returns the number of jobs without a row.
    std::size_t in_work() const;
    /// Waits at most so long for rows, and returns them.
    tl::expected<std::vector<RunRow>, std::string> take(std::chrono::milliseconds longest_wait);

  private:
    using Clock = std::chrono::steady_clock;

    struct Given {
        Job job;
        int tries = 0;  ///< That somebody from outside has ended.
    };
    struct Worker {
        pid_t child;
        os::Descriptor input;         ///< Jobs go there.
        os::Descriptor output;        ///< Rows come from there.
        std::deque<Given> jobs = {};  ///< The one in front is run.
        Clock::time_point begun = {};
        std::string unsent = {};
        std::string received = {};
        bool timed_out = false;
        bool has_answered = false;  ///< It has run a job to its end.
    };

    tl::expected<void, std::string> give_again(Given given);
    tl::expected<void, std::string> begin_worker();
    static void send(Worker& worker);
    /// Reads available output; returns false at the end of the output.
    bool receive(Worker& worker, std::vector<RunRow>& rows);
    tl::expected<void, std::string> bury(std::list<Worker>::iterator worker, std::vector<RunRow>& rows);
    void kill_if_late(Worker& worker) const;
    std::chrono::milliseconds until_timeout(std::chrono::milliseconds longest) const;

    PoolOptions options_;
    std::list<Worker> workers_;
};

}  // namespace gsim::batch
