#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"
#include "batch/store/results.h"

namespace gsim::batch {

/// How a plan is carried out.
struct BatchOptions {
    std::string results;  ///< File.
    std::size_t workers = 1;
    std::uint64_t memory_mb = 4096;  ///< Of each worker.
    double timeout_s = 600;          ///< Of each run, by the clock.
    Journal journal = Journal::write_ahead;
    std::optional<std::vector<std::uint64_t>> only = {};  ///< Numbers of jobs; nothing: all of them.
    bool anew = false;                                    ///< What is there already is run all the same.
    std::chrono::milliseconds lock_wait{0};               ///< For whoever else changes the file.
    bool retry = false;  ///< What crashed, took too long or too much memory is run again.
};

/// What came of it.
struct BatchTally {
    std::int64_t batch = 0;  ///< Its number in the results.
    std::uint64_t jobs = 0;
    std::uint64_t ran = 0;
    std::uint64_t reused = 0;      ///< They were there already.
    std::uint64_t failed = 0;      ///< Of both.
    std::uint64_t undrawn = 0;     ///< Pictures that were wanted, and could not be drawn.
    std::string why_undrawn = {};  ///< Of the first of these, in a sentence.
    double wall_s = 0;
    bool whole = false;  ///< Else it was cut off.

    std::uint64_t done() const { return ran + reused; }
};

/// Runs what has not been run yet, and puts it into the file of results as it comes. `stop`: no further job
/// is begun, those under way come to their end. `progress` is called now and then. The error is a sentence;
/// what was there by then is in the file.
tl::expected<BatchTally, std::string> run_batch(const Plan& plan, const BatchOptions& options,
                                                const std::atomic<bool>& stop,
                                                const std::function<void(const BatchTally&)>& progress);

}  // namespace gsim::batch
