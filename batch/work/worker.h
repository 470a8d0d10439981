#pragma once

#include <cstdint>

namespace gsim::batch {

/// What a worker is called with by the program that has it work, in front of its bound of memory in MiB.
inline constexpr const char* kWorkerWord = "--worker";

/// Runs the jobs that come on standard input, a line each (read_job()), and answers each with a line
/// (print_row()), until there are no more. The process changes no file, and takes no more than so much memory
/// for its data; where it would, it ends with kOutOfMemory. The exit status.
int work(std::uint64_t memory_mb);

/// The exit status of a worker that had not enough memory.
inline constexpr int kOutOfMemory = 12;

}  // namespace gsim::batch
