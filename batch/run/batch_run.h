#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/plan/plan.h"
#include "batch/store/results.h"

namespace gsim::batch {

/// Options for the execution of a plan.
struct BatchOptions {
    std::string results;  ///< File.
    std::size_t workers = 1;
    std::uint64_t memory_mb = 4096;  ///< For each worker.
    double timeout_s = 600;          ///< For each run, by the clock.
    Journal journal = Journal::write_ahead;
    std::optional<std::vector<std::uint64_t>> only = {};  ///< Numbers of jobs; empty: all of them.
    bool rerun = false;                                   ///< Repeats runs that already exist.
    std::chrono::milliseconds lock_timeout{0};            ///< For other programs that change the file.
    bool retry = false;  ///< Repeats runs that crashed, took too long or too much memory.
};

/// Result of a batch.
struct BatchTally {
    std::int64_t batch = 0;  ///< Its number in the results.
    std::uint64_t jobs = 0;
    std::uint64_t ran = 0;
    std::uint64_t reused = 0;              ///< They were there already.
    std::uint64_t failed = 0;              ///< Among both.
    std::uint64_t missing_pictures = 0;    ///< Requested pictures that could not be drawn.
    std::string first_picture_error = {};  ///< Message of the first of these.
    double wall_time_s = 0;
    bool complete = false;  ///< Else it was cut off.

    std::uint64_t done() const { return ran + reused; }
};

/// Runs the jobs that have not been run yet, and writes their results to the file as they come. `stop`: no
/// further job is begun, those in progress are completed. `progress` is called from time to time. The error
/// is a message; the results so far are in the file.
Result<BatchTally> run_batch(const Plan& plan, const BatchOptions& options, const std::atomic<bool>& stop,
                             const std::function<void(const BatchTally&)>& progress);

}  // namespace gsim::batch
