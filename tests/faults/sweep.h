#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/faults/job.h"

namespace gsim::faults {

/// Returns true if all cases are tried (GSIM_TEST_ALL=1, `make test-all`), and not a short sample.
bool tries_all();

/// Returns which of `count` calls are made to fail: all of them if all are wanted or they are few; else so
/// many at each end, and as many between, drawn with a fixed seed.
std::vector<std::uint64_t> selected(std::uint64_t count, std::uint64_t at_each_end);

/// Returns the error in how a job ended under a fault; empty: none. It may end as without the fault, or with
/// status 2 and a message. Each file is as it was before, or as it is after a run without faults; no other
/// file exists.
std::string find_wrong(const Job& job, const Outcome& is_clean, const Outcome& found);

/// Number of times that a fault was tried, and how the runs ended.
struct Count {
    std::uint64_t of = 0;  ///< Calls that there are.
    std::uint64_t attempts = 0;
    std::uint64_t struck = 0;    ///< Runs in which the fault came.
    std::uint64_t done = 0;      ///< Runs that ended as without a fault.
    std::uint64_t reported = 0;  ///< Runs that ended with status 2 and a message.
    std::vector<std::string> wrong = {};
};

/// Lets calls of a kind fail, one in each run: of many 50 at each end and 50 between, or 10 if all later ones
/// fail, too.
Count sweep(const Job& job, const Conditions& injected_fault);

/// Prints a row for the table of the documentation on standard output if GSIM_FAULT_TABLE is set.
void print_row(const std::string& injected_fault, const std::string& job, const Count& count);

}  // namespace gsim::faults
