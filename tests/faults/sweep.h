#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/faults/job.h"

namespace gsim::faults {

/// Whether everything is tried (GSIM_TEST_ALL=1, `make test-all`), and not a sample that is over soon.
bool tries_all();

/// Which of `count` calls are made to fail: all of them where all are wanted or there are few; else so many
/// at each end, and as many between, drawn with a fixed seed.
std::vector<std::uint64_t> chosen(std::uint64_t count, std::uint64_t at_each_end);

/// What is wrong with how a job ended under a fault; empty: nothing. It may end as without the fault, or with
/// status 2 and a sentence; each file is as it was before, or as it is after a run without faults; no other
/// is there.
std::string find_wrong(const Job& job, const Outcome& clean, const Outcome& found);

/// How often a fault was tried, and how the runs ended.
struct Count {
    std::uint64_t of = 0;  ///< Calls that there are.
    std::uint64_t tried = 0;
    std::uint64_t struck = 0;  ///< Runs in which the fault came.
    std::uint64_t done = 0;    ///< Runs that ended as without a fault.
    std::uint64_t told = 0;    ///< Runs that ended with status 2 and a sentence.
    std::vector<std::string> wrong = {};
};

/// Lets calls of a kind fail, one in each run: of many 50 at each end and 50 between, or 10 where all later
/// ones fail, too.
Count sweep(const Job& job, const Conditions& fault);

/// A row for the table of the documentation, on standard output where GSIM_FAULT_TABLE is set.
void print_row(const std::string& fault, const std::string& job, const Count& count);

}  // namespace gsim::faults
