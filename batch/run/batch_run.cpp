#include "batch/run/batch_run.h"

#include <chrono>
#include <unordered_map>

#include <fmt/format.h>

#include "base/os/file_lock.h"
#include "batch/run/current_executable.h"
#include "batch/run/run_cache.h"
#include "batch/store/results.h"
#include "batch/work/worker.h"
#include "batch/work/worker_pool.h"

namespace gsim::batch {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPollInterval(200);
constexpr std::uint64_t kJobsPerPoll = 64;  // jobs
constexpr std::chrono::milliseconds kCommitInterval(500);

std::vector<std::string> worker_command(std::uint64_t memory_mb) {
    return {current_executable(), kWorkerOption, fmt::format("{}", memory_mb)};
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

    Result<BatchTally> run() {
        auto lock = os::FileLock::get(options_.results, options_.lock_timeout);
        if (!lock) return Unexpected(lock.error());
        auto results = Results::open(options_.results, options_.journal);
        if (!results) return Unexpected(results.error());
        results_ = &*results;
        tally_.jobs = options_.only ? options_.only->size() : jobs_.size();
        const auto ran = results_->begin_batch(plan_.name, tally_.jobs, run_cache_.version()).and_then([&] {
            return run_jobs();
        });
        tally_.batch = results_->batch();
        if (!ran) {
            static_cast<void>(results_->end_batch(false));
            return Unexpected(ran.error());
        }
        tally_.complete = tally_.done() == tally_.jobs;
        if (const auto ended = results_->end_batch(tally_.complete); !ended) return Unexpected(ended.error());
        report_progress();
        return tally_;
    }

  private:
    Result<void> run_jobs() {
        std::uint64_t next = 0;
        while (true) {
            while (!stop_ && next < tally_.jobs && pool_.has_capacity()) {
                if (auto begun = begin(jobs_.job(job_number(next++))); !begun) return begun;
                if (auto committed = commit_if_due(); !committed) return committed;
                // Results are collected regularly, so that the end of a run is noticed in time.
                if (next % kJobsPerPoll == 0) {
                    if (auto collected = collect_rows(std::chrono::milliseconds(0)); !collected)
                        return collected;
                }
            }
            if (pool_.pending_count() == 0 && (stop_ || next == tally_.jobs)) return {};
            if (auto collected = collect_rows(kPollInterval); !collected) return collected;
            if (auto committed = commit_if_due(); !committed) return committed;
        }
    }

    Result<void> collect_rows(std::chrono::milliseconds max_wait) {
        if (pool_.pending_count() == 0) return {};
        auto rows = pool_.collect(max_wait);
        if (!rows) return Unexpected(rows.error());
        for (const RunRow& row : *rows) {
            if (auto collected = collect(row); !collected) return collected;
        }
        return {};
    }

    std::uint64_t job_number(std::uint64_t index) const {
        return options_.only ? (*options_.only)[index] : index;
    }

    /// Records a job that was done before, or gives it to a worker.
    Result<void> begin(Job job) {
        RunKey key = run_cache_.run_key(job);
        using LookupResult = Result<std::optional<Results::StoredRun>>;
        const LookupResult found =
            options_.rerun ? LookupResult() : run_cache_.find(*results_, key, job, options_.retry);
        if (!found) return Unexpected(found.error());
        if (*found) {
            ++tally_.reused;
            return record(job.number, (*found)->run, (*found)->is_clean, true);
        }
        // The same run is in progress: it counts for both jobs.
        if (const auto same = jobs_in_progress_.find(key.key); same != jobs_in_progress_.end()) {
            pending_jobs_.at(same->second).others.push_back(job.number);
            return {};
        }
        jobs_in_progress_.emplace(key.key, job.number);
        pending_jobs_.insert_or_assign(job.number, PendingJob{job, std::move(key), {}});
        return pool_.submit(std::move(job));
    }

    Result<void> collect(const RunRow& row) {
        const auto pending = pending_jobs_.find(row.number);
        if (pending == pending_jobs_.end()) return Unexpected("a result row without a job");
        const auto run = results_->add(pending->second.job, pending->second.key, row, run_cache_.version());
        const std::vector<std::uint64_t> others = std::move(pending->second.others);
        jobs_in_progress_.erase(pending->second.key.key);
        pending_jobs_.erase(pending);
        if (!run) return Unexpected(run.error());
        ++tally_.ran;
        if (!row.documents.picture_error.empty() && tally_.missing_pictures++ == 0)
            tally_.first_picture_error = row.documents.picture_error;
        for (const std::uint64_t other : others) {
            ++tally_.reused;
            if (auto recorded = record(other, *run, row.outcome.is_clean(), true); !recorded) return recorded;
        }
        return record(row.number, *run, row.outcome.is_clean(), false);
    }

    Result<void> record(std::uint64_t job, std::int64_t run, bool is_clean, bool reused) {
        tally_.failed += is_clean ? 0 : 1;
        return results_->record(job, run, reused);
    }

    /// Commits and reports new results from time to time, so that others see them.
    Result<void> commit_if_due() {
        const auto now = Clock::now();
        if (now < next_commit_) return {};
        next_commit_ = now + kCommitInterval;
        report_progress();
        return results_->commit();
    }

    void report_progress() {
        tally_.wall_time_s = std::chrono::duration<double>(Clock::now() - start_).count();
        progress_(tally_);
    }

    struct PendingJob {
        Job job;
        RunKey key;
        std::vector<std::uint64_t> others;  ///< Jobs that are the same.
    };

    const BatchOptions& options_;
    const std::atomic<bool>& stop_;
    const std::function<void(const BatchTally&)>& progress_;
    const Plan& plan_;
    Jobs jobs_;
    RunCache run_cache_;
    WorkerPool pool_;
    Results* results_ = nullptr;
    std::unordered_map<std::uint64_t, PendingJob> pending_jobs_;
    std::unordered_map<std::string, std::uint64_t> jobs_in_progress_;  ///< Numbers in pending_jobs_, by keys.
    BatchTally tally_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_commit_ = start_ + kCommitInterval;
};

}  // namespace

Result<BatchTally> run_batch(const Plan& plan, const BatchOptions& options, const std::atomic<bool>& stop,
                             const std::function<void(const BatchTally&)>& progress) {
    return BatchRun(plan, options, stop, progress).run();
}

}  // namespace gsim::batch
