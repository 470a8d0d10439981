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

/// How jobs are run.
struct PoolOptions {
    std::vector<std::string> command;  ///< Begins a worker.
    std::size_t workers = 1;
    double timeout_s = 600;  ///< Of a job, by the clock; its worker is killed behind it.
};

/// Processes that run jobs. One that crashes, takes too long or too much memory costs the row of its job
/// alone: another one takes its place.
class WorkerPool {
  public:
    explicit WorkerPool(PoolOptions options);
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;
    /// Kills the workers that still work.
    ~WorkerPool();

    /// Whether a job can be taken that will soon be begun.
    bool has_room() const;
    /// The error: no process can be begun.
    tl::expected<void, std::string> give(Job job);
    /// How many jobs have no row yet.
    std::size_t in_work() const;
    /// Waits at most so long until there are rows, and takes those.
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
    /// Reads what there is; false at the end of its output.
    bool receive(Worker& worker, std::vector<RunRow>& rows);
    tl::expected<void, std::string> bury(std::list<Worker>::iterator worker, std::vector<RunRow>& rows);
    void kill_if_late(Worker& worker) const;
    std::chrono::milliseconds until_timeout(std::chrono::milliseconds longest) const;

    PoolOptions options_;
    std::list<Worker> workers_;
};

}  // namespace gsim::batch
