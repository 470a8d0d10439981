#include "batch/work/worker.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/os/confinement.h"
#include "base/os/installation.h"
#include "batch/work/run_job.h"

namespace gsim::batch {

namespace {

// The stack is not unwound, because destructors may need memory, too.
[[noreturn]] void exit_out_of_memory() {
    ::_exit(kOutOfMemory);
}

void limit_memory([[maybe_unused]] std::uint64_t memory_mb) {
    std::set_new_handler(exit_out_of_memory);
#ifndef GSIM_SANITIZES_ADDRESSES  // that reserves the complete address space
    const rlimit limit{memory_mb << 20U, memory_mb << 20U};
    ::setrlimit(RLIMIT_DATA, &limit);
#endif
    const rlimit no_core_dump{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core_dump);
}

/// Programs and scripts may be untrusted, so this process must not change any file. Without landlock only the
/// engine's checks protect the files.
void confine_to_read_only() {
    const std::filesystem::path executable_folder = os::program_folder();
    static_cast<void>(os::confine(
        {.read = {"/"},
         .run = {"/usr", "/lib", "/lib64", executable_folder, executable_folder.parent_path() / "libexec"},
         .written = {},
         .changed = {}}));
}

bool write_row(const RunRow& row) {
    const std::string line = print_row(row) + '\n';
    return std::fwrite(line.data(), 1, line.size(), stdout) == line.size() && std::fflush(stdout) == 0;
}

}  // namespace

int run_worker(std::uint64_t memory_mb) {
    // If the parent that sends the jobs is killed, no worker remains.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // A signal that ends a job of a cluster or a terminal is meant for the main program, which lets each run
    // complete.
    std::signal(SIGTERM, SIG_IGN);
    std::signal(SIGINT, SIG_IGN);
    limit_memory(memory_mb);
    confine_to_read_only();
    JobRunner runner;
    for (std::string line; std::getline(std::cin, line);) {
        const auto job = read_job(line);
        if (!job) {
            std::fprintf(stderr, "gsim-batch: %s\n", job.error().message.c_str());
            return 2;
        }
        const RunRow row = runner.run(*job);
        // The engine catches std::bad_alloc: here it is caused by the worker's limit.
        if (row.outcome.status == "refused" && row.outcome.message.find("out of memory") != std::string::npos)
            exit_out_of_memory();
        if (!write_row(row)) return 2;  // no reader left
    }
    return 0;
}

}  // namespace gsim::batch
