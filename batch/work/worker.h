#pragma once

#include <cstdint>

namespace gsim::batch {

/// Word with which the parent program calls a worker, in front of its memory limit in MiB.
inline constexpr const char* kWorkerOption = "--worker";

/// Runs the jobs from standard input, a line each (read_job()), and writes a line (print_row()) for each,
/// until the input ends. The process changes no file, and uses no more than so much memory for its data;
/// otherwise it ends with kOutOfMemory. Returns the exit status.
int run_worker(std::uint64_t memory_mb);

/// Exit status of a worker that ran out of memory.
inline constexpr int kOutOfMemory = 12;

}  // namespace gsim::batch
