// Programs that are ended from outside, in front of each of their system calls.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/faults/jobs.h"
#include "tests/faults/sweep.h"

namespace gsim::faults::kills_test {
namespace {

// Those that change what is there.
const std::vector<std::string> kChanging = {"gsim-data set", "gsim-run, kept data", "gcode2lua"};
// Returns the calls of a program on files: all, or those that change them.
std::vector<Kind> calls() {
    std::vector<Kind> all = {Kind::write, Kind::open, Kind::rename, Kind::remove, Kind::lock};
    if (tries_all()) all.insert(all.end(), {Kind::close, Kind::fsync, Kind::mode, Kind::look});
    return all;
}

bool is_left_over(const std::string& name) {
    return name.ends_with(".tmp") || name.ends_with(".lock");
}

bool sets_all_rotary_axes(const Job& job, const Outcome& is_clean, const std::string& name,
                          const std::string& text) {
    const auto before = job.files.find(name);
    const auto after = is_clean.files.find(name);
    return (before != job.files.end() && before->second == text) ||
           (after != is_clean.files.end() && after->second == text);
}

struct Toll {
    std::uint64_t count = 0;
    std::uint64_t with_new = 0;   ///< After which the new files are all there.
    std::uint64_t leftovers = 0;  ///< After which something else was there, too.
};

// Leftover files do not disturb the next run, which is complete as long as no signal kills it.
void expect_next_run_goes_well(const Job& job, const Outcome& killed) {
    Job next = job;
    next.files = killed.files;
    const Outcome repeated = run(next, {});
    EXPECT_EQ(repeated.status, 0) << repeated.err;
    for (const auto& [name, text] : repeated.files)
        EXPECT_TRUE(killed.files.count(name) > 0 || !is_left_over(name)) << name;
}

void expect_old_or_new(const Job& job, const Outcome& is_clean, const Conditions& kill, Toll& kills) {
    const Outcome killed = run(job, kill);
    EXPECT_EQ(killed.ended_by, fmt::format("signal {}", -kill.error)) << job.name << kill.which;
    bool left = false;
    for (const auto& [name, text] : killed.files) {
        left |= is_left_over(name);
        EXPECT_TRUE(is_left_over(name) || sets_all_rotary_axes(job, is_clean, name, text))
            << job.name << ": " << name;
    }
    for (const auto& [name, text] : job.files) EXPECT_EQ(killed.files.count(name), 1U) << name;
    ++kills.count;
    if (left) ++kills.leftovers;
    if (killed.files == is_clean.files) ++kills.with_new;
    if (left) expect_next_run_goes_well(job, killed);
}

Toll kill_everywhere(const Job& job, int signal) {
    Toll kills;
    const Outcome is_clean = run(job, {.kind = Kind::write});
    for (const Kind kind : calls()) {
        const std::uint64_t calls = is_clean.calls[static_cast<std::size_t>(kind)];
        for (std::uint64_t which = 1; which <= calls; ++which)
            expect_old_or_new(job, is_clean, {.kind = kind, .which = which, .error = -signal}, kills);
    }
    return kills;
}

void print_row(const std::string& signal, const std::string& job, const Toll& kills) {
    if (std::getenv("GSIM_FAULT_TABLE") == nullptr) return;
    std::fputs(
        fmt::format("| {} | {} | {} | {} | {} |\n", signal, job, kills.count, kills.with_new, kills.leftovers)
            .c_str(),
        stdout);
}

class Termination : public testing::Test {
  protected:
    void SetUp() override {
        if (kInstrumented) GTEST_SKIP() << "what is built into the program makes system calls of its own";
    }
};

TEST_F(Termination, SigkillLeavesCompleteFilesAndNextRunSucceeds) {
    for (const std::string& name : kChanging) {
        const Toll kills = kill_everywhere(job_named(name), SIGKILL);
        print_row("SIGKILL", name, kills);
        EXPECT_GE(kills.count, 5U) << name;
        EXPECT_GT(kills.leftovers, 0U) << name << ": it was not killed while it wrote";
    }
}

TEST_F(Termination, CatchableSignalsLeaveNoLeftovers) {
    for (const auto& [signal, text] : std::vector<std::pair<int, std::string>>{
             {SIGTERM, "SIGTERM"}, {SIGINT, "SIGINT"}, {SIGHUP, "SIGHUP"}}) {
        for (const std::string& name : kChanging) {
            if (signal != SIGTERM && !tries_all() && name != kChanging.front()) continue;
            const Toll kills = kill_everywhere(job_named(name), signal);
            print_row(text, name, kills);
            EXPECT_EQ(kills.leftovers, 0U) << name << ", " << text;
        }
    }
}

}  // namespace
}  // namespace gsim::faults::kills_test
