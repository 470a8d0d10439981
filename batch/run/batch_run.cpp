#include "batch/run/batch_run.h"

#include <chrono>
#include <unordered_map>

#include <fmt/format.h>

#include "base/os/file_lock.h"
#include "batch/run/known_runs.h"
#include "batch/run/own_program.h"
#include "batch/store/results.h"
#include "batch/work/worker.h"
#include "batch/work/worker_pool.h"

namespace gsim::batch {

namespace {

using Fault = tl::unexpected<std::string>;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kWait(200);
constexpr std::uint64_t kLookEach = 64;  // jobs
constexpr std::chrono::milliseconds kCommitEach(500);

std::vector<std::string> worker_command(std::uint64_t memory_mb) {
    return {own_program(), kWorkerWord, fmt::format("{}", memory_mb)};
}

class BatchRun {
  public:
    BatchRun(const Plan& plan, const BatchOptions& options, const std::atomic<bool>& stop,
             const std::function<void(const BatchTally&)>& progress)
        : options_(options),
          stop_(stop),
          progress_(progress),
          plan_(plan),
          jobs_(plan),
          pool_({.command = worker_command(options.memory_mb),
                 .workers = options.workers,
                 .timeout_s = options.timeout_s}) {}

    tl::expected<BatchTally, std::string> run() {
        auto lock = os::FileLock::get(options_.results, options_.lock_wait);
        if (!lock) return Fault(lock.error());
        auto results = Results::open(options_.results, options_.journal);
        if (!results) return Fault(results.error());
        results_ = &*results;
        tally_.jobs = options_.only ? options_.only->size() : jobs_.size();
        const auto ran =
            results_->begin_batch(plan_.name, tally_.jobs, known_.version()).and_then([&] { return go(); });
        tally_.batch = results_->batch();
        if (!ran) {
            static_cast<void>(results_->end_batch(false));
            return Fault(ran.error());
        }
        tally_.whole = tally_.done() == tally_.jobs;
        if (const auto ended = results_->end_batch(tally_.whole); !ended) return Fault(ended.error());
        tell();
        return tally_;
    }

  private:
    SqlDone go() {
        std::uint64_t next = 0;
        while (true) {
            while (!stop_ && next < tally_.jobs && pool_.has_room()) {
                if (auto begun = begin(jobs_.job(number_of(next++))); !begun) return begun;
                if (auto kept = keep_up(); !kept) return kept;
                // Results are collected regularly, so that the end of a run is noticed in time.
                if (next % kLookEach == 0) {
                    if (auto taken = take_rows(std::chrono::milliseconds(0)); !taken) return taken;
                }
            }
            if (pool_.in_work() == 0 && (stop_ || next == tally_.jobs)) return {};
            if (auto taken = take_rows(kWait); !taken) return taken;
            if (auto kept = keep_up(); !kept) return kept;
        }
    }

    SqlDone take_rows(std::chrono::milliseconds longest_wait) {
        if (pool_.in_work() == 0) return {};
        auto rows = pool_.take(longest_wait);
        if (!rows) return Fault(rows.error());
        for (const RunRow& row : *rows) {
            if (auto taken = take(row); !taken) return taken;
        }
        return {};
    }

    std::uint64_t number_of(std::uint64_t place) const {
        return options_.only ? (*options_.only)[place] : place;
    }

    /// Records a job that was done before, or gives it to a worker.
    SqlDone begin(Job job) {
        RunKey key = known_.key_of(job);
        using Found = tl::expected<std::optional<Results::FoundRun>, std::string>;
        const Found found = options_.anew ? Found() : known_.find(*results_, key, job, options_.retry);
        if (!found) return Fault(found.error());
        if (*found) {
            ++tally_.reused;
            return note(job.number, (*found)->run, (*found)->is_clean, true);
        }
        // The same run is in progress: it counts for both jobs.
        if (const auto same = under_way_.find(key.key); same != under_way_.end()) {
            waiting_.at(same->second).others.push_back(job.number);
            return {};
        }
        under_way_.emplace(key.key, job.number);
        waiting_.insert_or_assign(job.number, Waiting{job, std::move(key), {}});
        return pool_.give(std::move(job));
    }

    SqlDone take(const RunRow& row) {
        const auto waiting = waiting_.find(row.number);
        if (waiting == waiting_.end()) return Fault("a row of no job");
        const auto run = results_->add(waiting->second.job, waiting->second.key, row, known_.version());
        const std::vector<std::uint64_t> others = std::move(waiting->second.others);
        under_way_.erase(waiting->second.key.key);
        waiting_.erase(waiting);
        if (!run) return Fault(run.error());
        ++tally_.ran;
        if (!row.picture_fault.empty() && tally_.undrawn++ == 0) tally_.why_undrawn = row.picture_fault;
        for (const std::uint64_t other : others) {
            ++tally_.reused;
            if (auto noted = note(other, *run, row.is_clean(), true); !noted) return noted;
        }
        return note(row.number, *run, row.is_clean(), false);
    }

    SqlDone note(std::uint64_t job, std::int64_t run, bool is_clean, bool reused) {
        tally_.failed += is_clean ? 0 : 1;
        return results_->note(job, run, reused);
    }

    /// Commits and reports new results from time to time, so that others see them.
    SqlDone keep_up() {
        const auto now = Clock::now();
        if (now < next_commit_) return {};
        next_commit_ = now + kCommitEach;
        tell();
        return results_->commit();
    }

    void tell() {
        tally_.wall_s = std::chrono::duration<double>(Clock::now() - begun_).count();
        progress_(tally_);
    }

    struct Waiting {
        Job job;
        RunKey key;
        std::vector<std::uint64_t> others;  ///< Jobs that are the same.
    };

    const BatchOptions& options_;
    const std::atomic<bool>& stop_;
    const std::function<void(const BatchTally&)>& progress_;
    const Plan& plan_;
    Jobs jobs_;
    KnownRuns known_;
    WorkerPool pool_;
    Results* results_ = nullptr;
    std::unordered_map<std::uint64_t, Waiting> waiting_;
    std::unordered_map<std::string, std::uint64_t> under_way_;  ///< Numbers in waiting_, by keys.
    BatchTally tally_;
    Clock::time_point begun_ = Clock::now();
    Clock::time_point next_commit_ = begun_ + kCommitEach;
};

}  // namespace

tl::expected<BatchTally, std::string> run_batch(const Plan& plan, const BatchOptions& options,
                                                const std::atomic<bool>& stop,
                                                const std::function<void(const BatchTally&)>& progress) {
    return BatchRun(plan, options, stop, progress).run();
}

}  // namespace gsim::batch
