#include "batch/batch_run.h"

#include <chrono>
#include <filesystem>
#include <unordered_map>

#include <fmt/format.h>

#include "base/os/file_lock.h"
#include "base/os/installation.h"
#include "batch/store/results.h"
#include "batch/work/input_files.h"
#include "batch/work/run_options.h"
#include "batch/work/sha256.h"
#include "batch/work/worker.h"
#include "batch/work/worker_pool.h"
#include "engine/host.h"
#include "engine/system/host_of_system.h"
#include "engine/version.h"

namespace gsim::batch {

namespace {

using Fault = tl::unexpected<std::string>;
using Clock = std::chrono::steady_clock;
using nlohmann::json;

constexpr const char* kOwnProgram = "/proc/self/exe";
constexpr std::chrono::milliseconds kWait(200);
constexpr std::chrono::milliseconds kCommitEach(500);

/// This program, whatever it was called by: what another one gives may differ.
std::string version_of(InputFiles& files) {
    return fmt::format("{}+{}", engine::version(), files.hash_of(kOwnProgram).substr(0, 16));
}

std::vector<std::string> worker_command(std::uint64_t memory_mb) {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink(kOwnProgram, ignored);
    return {program.string(), kWorkerWord, fmt::format("{}", memory_mb)};
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
          host_(engine::host_of_system()),
          version_(version_of(files_)),
          pool_({.command = worker_command(options.memory_mb),
                 .workers = options.workers,
                 .timeout_s = options.timeout_s}) {}

    tl::expected<BatchTally, std::string> run() {
        auto lock = os::FileLock::get(options_.results, std::chrono::milliseconds(0));
        if (!lock)
            return Fault(fmt::format("another batch writes '{}' ({})", options_.results, lock.error()));
        auto results = Results::open(options_.results);
        if (!results) return Fault(results.error());
        results_ = &*results;
        tally_.jobs = jobs_.size();
        const auto ran =
            results_->begin_batch(plan_.name, tally_.jobs, version_).and_then([&] { return go(); });
        if (!ran) {
            static_cast<void>(results_->end_batch(false));
            return Fault(fmt::format("results '{}': {}", options_.results, ran.error()));
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
            while (!stop_ && next < jobs_.size() && pool_.has_room()) {
                if (auto begun = begin(jobs_.job(next++)); !begun) return begun;
                if (auto kept = keep_up(); !kept) return kept;
            }
            if (pool_.in_work() == 0 && (stop_ || next == jobs_.size())) return {};
            auto rows = pool_.take(kWait);
            if (!rows) return Fault(rows.error());
            for (const RunRow& row : *rows) {
                if (auto taken = take(row); !taken) return taken;
            }
            if (auto kept = keep_up(); !kept) return kept;
        }
    }

    /// A job that was done before is noted, another one given to a worker.
    SqlDone begin(Job job) {
        RunKey key = key_of(job);
        const auto hash_of = [this](const std::string& name) { return files_.hash_of(name); };
        const auto found = results_->find(key.key, hash_of, job.keeps_report, options_.retry);
        if (!found) return Fault(found.error());
        if (*found) {
            ++tally_.reused;
            return note(job.number, (*found)->run, (*found)->is_clean, true);
        }
        waiting_.insert_or_assign(job.number, Waiting{job, std::move(key)});
        return pool_.give(std::move(job));
    }

    SqlDone take(const RunRow& row) {
        const auto waiting = waiting_.find(row.number);
        if (waiting == waiting_.end()) return Fault("a row of no job");
        const auto run = results_->add(waiting->second.job, waiting->second.key, row, version_);
        waiting_.erase(waiting);
        if (!run) return Fault(run.error());
        ++tally_.ran;
        return note(row.number, *run, row.is_clean(), false);
    }

    SqlDone note(std::uint64_t job, std::int64_t run, bool is_clean, bool reused) {
        tally_.failed += is_clean ? 0 : 1;
        return results_->note(job, run, reused);
    }

    /// All that is known before a run and makes it what it is. What it reads beside that is looked at once it
    /// is known (Results::find()).
    RunKey key_of(const Job& job) {
        RunKey key;
        key.program_sha256 = files_.hash_of(job.program);
        key.machine_sha256 = hash_of_machine(job.machine);
        json files = json::object();
        for (const auto& [name, value] : job.options.items()) {
            if (find_option(name)->kind == RunOption::Kind::file)
                files[name] = files_.hash_of(value.get<std::string>());
        }
        const json all{{"version", version_},
                       {"program", {job.program, key.program_sha256}},
                       {"machine", {job.machine, key.machine_sha256}},
                       {"options", job.options},
                       {"files", files},
                       {"settings", settings_json(job.settings)}};
        key.key = sha256(all.dump(-1, ' ', false, json::error_handler_t::replace));
        return key;
    }

    std::string hash_of_machine(const std::string& name) {
        if (name.empty()) return {};
        auto found = machines_.find(name);
        if (found == machines_.end())
            found = machines_.emplace(name, host_.find(engine::NameKind::machine, name).value_or(name)).first;
        return files_.hash_of(found->second);
    }

    /// What comes is seen by others, and told, now and then.
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
    };

    const BatchOptions& options_;
    const std::atomic<bool>& stop_;
    const std::function<void(const BatchTally&)>& progress_;
    const Plan& plan_;
    Jobs jobs_;
    engine::Host host_;
    InputFiles files_;
    std::string version_;
    WorkerPool pool_;
    Results* results_ = nullptr;
    std::unordered_map<std::uint64_t, Waiting> waiting_;
    std::unordered_map<std::string, std::string> machines_;
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
