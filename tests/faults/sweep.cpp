#include "tests/faults/sweep.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <random>
#include <set>
#include <thread>

#include <fmt/format.h>

namespace gsim::faults {

namespace {

constexpr std::uint64_t kMany = 50;
constexpr std::uint64_t kFew = 10;
constexpr unsigned kSeed = 14;
constexpr int kRefused = 2;
constexpr std::size_t kMaxShownLength = 5;

// Returns true if a run that was made to fail reports why; with --json on standard output.
bool tells(const Outcome& is_clean, const Outcome& found) {
    return (!found.err.empty() && found.err != is_clean.err) ||
           (!found.out.empty() && found.out != is_clean.out);
}

// A lock with an unknown owner stays; it blocks no process.
bool is_lock(const std::string& name) {
    return name.ends_with(".lock");
}

std::string file_fault(const Job& job, const Outcome& is_clean, const Outcome& found) {
    for (const auto& [name, text] : found.files) {
        if (is_lock(name)) continue;
        const auto before = job.files.find(name);
        const auto after = is_clean.files.find(name);
        const bool is_old = before != job.files.end() && before->second == text;
        const bool is_new = after != is_clean.files.end() && after->second == text;
        if (!is_old && !is_new)
            return fmt::format("'{}' is {}", name,
                               after == is_clean.files.end() ? "left over" : "neither old nor new");
    }
    for (const auto& [name, text] : job.files) {
        if (found.files.count(name) == 0) return fmt::format("'{}' is gone", name);
    }
    return {};
}

// Returns the error of a run under this fault; empty: none.
std::string find_wrong_with(const Job& job, const Conditions& injected_fault, const Outcome& is_clean,
                            const Outcome& found) {
    std::string wrong = find_wrong(job, is_clean, found);
    if (!wrong.empty() || found.status == is_clean.status || injected_fault.reason.empty()) return wrong;
    const bool named = (found.err + found.out).find(injected_fault.reason) != std::string::npos;
    return named ? "" : fmt::format("the reason, '{}', is not named", injected_fault.reason);
}

void record_outcome(Count& count, const Job& job, const Conditions& injected_fault, const Outcome& is_clean,
                    const Outcome& found) {
    if (found.struck > 0) ++count.struck;
    ++(found.status == is_clean.status ? count.done : count.reported);
    const std::string wrong = find_wrong_with(job, injected_fault, is_clean, found);
    if (!wrong.empty() && count.wrong.size() < kMaxShownLength)
        count.wrong.push_back(
            fmt::format("call {}: {}; it said: {}", injected_fault.which, wrong, found.err));
}

}  // namespace

bool tries_all() {
    const char* const expected_value = std::getenv("GSIM_TEST_ALL");
    return expected_value != nullptr && std::string_view(expected_value) == "1";
}

std::vector<std::uint64_t> selected(std::uint64_t count, std::uint64_t at_each_end) {
    std::set<std::uint64_t> which;
    if (tries_all() || count <= 3 * at_each_end) {
        for (std::uint64_t i = 1; i <= count; ++i) which.insert(i);
        return {which.begin(), which.end()};
    }
    for (std::uint64_t i = 1; i <= at_each_end; ++i) {
        which.insert(i);
        which.insert(count + 1 - i);
    }
    std::mt19937 random(kSeed);
    std::uniform_int_distribution<std::uint64_t> between(at_each_end + 1, count - at_each_end);
    while (which.size() < 3 * at_each_end) which.insert(between(random));
    return {which.begin(), which.end()};
}

std::string find_wrong(const Job& job, const Outcome& is_clean, const Outcome& found) {
    if (!found.ended_by.empty()) return fmt::format("ended by {}", found.ended_by);
    if (found.status == is_clean.status) {
        if (found.out != is_clean.out) return "another standard output with the same status";
        return found.files == is_clean.files ? "" : "other files with the same status";
    }
    if (found.status != kRefused) return fmt::format("status {}", found.status);
    if (!tells(is_clean, found)) return "status 2 without a word";
    return file_fault(job, is_clean, found);
}

Count sweep(const Job& job, const Conditions& injected_fault) {
    Conditions none = injected_fault;
    none.which = 0;
    const Outcome is_clean = run(job, none);
    Count count;
    count.of = is_clean.calls[static_cast<std::size_t>(injected_fault.kind)];
    const std::vector<std::uint64_t> all = selected(count.of, injected_fault.repeated ? kFew : kMany);
    count.attempts = all.size();
    std::atomic<std::size_t> next = 0;
    std::mutex counting;
    const auto work = [&] {
        for (std::size_t i = next++; i < all.size(); i = next++) {
            Conditions one = injected_fault;
            one.which = all[i];
            const Outcome found = run(job, one);
            const std::lock_guard lock(counting);
            record_outcome(count, job, one, is_clean, found);
        }
    };
    std::thread other(work);
    work();
    other.join();
    return count;
}

void print_row(const std::string& injected_fault, const std::string& job, const Count& count) {
    if (std::getenv("GSIM_FAULT_TABLE") == nullptr) return;
    std::fputs(fmt::format("| {} | {} | {} | {} | {} | {} |\n", injected_fault, job, count.of, count.attempts,
                           count.reported, count.done)
                   .c_str(),
               stdout);
}

}  // namespace gsim::faults
