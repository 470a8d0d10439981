// System calls that fail: each call of a program once, with each error that it may have, and in part.

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/faults/jobs.h"
#include "tests/faults/sweep.h"

namespace gsim::faults::calls_test {
namespace {

struct InjectedFault {
    Kind kind;
    int error;
    std::string_view name;
};

// If a file cannot be opened or checked, the program may report the reason of a later error.
std::string reason_of(const InjectedFault& injected_fault) {
    return injected_fault.kind == Kind::open || injected_fault.kind == Kind::look
               ? ""
               : std::strerror(injected_fault.error);
}

void expect_told(const std::vector<InjectedFault>& faults) {
    for (const InjectedFault& injected_fault : faults) {
        for (const Job& job : jobs()) {
            const Count count = sweep(job, {.kind = injected_fault.kind,
                                            .error = injected_fault.error,
                                            .reason = reason_of(injected_fault)});
            print_row(
                fmt::format("{}, {}", injected_fault.name,
                            injected_fault.error == kShort ? "in part" : std::strerror(injected_fault.error)),
                job.name, count);
            EXPECT_EQ(count.struck, count.attempts) << job.name << ", " << injected_fault.name;
            const bool every_job_does =
                injected_fault.kind == Kind::write || injected_fault.kind == Kind::read;
            EXPECT_TRUE(count.of > 0 || !every_job_does) << job.name << ", " << injected_fault.name;
            for (const std::string& wrong : count.wrong)
                ADD_FAILURE() << job.name << ", " << injected_fault.name << ", "
                              << std::strerror(injected_fault.error) << ": " << wrong;
        }
    }
}

class SystemCallErrors : public testing::Test {
  protected:
    void SetUp() override {
        if (kInstrumented) GTEST_SKIP() << "what is built into the program makes system calls of its own";
    }
};

TEST_F(SystemCallErrors, FailureOfEachWriteIsHandled) {
    expect_told({{Kind::write, ENOSPC, "a write"},
                 {Kind::write, EIO, "a write"},
                 {Kind::write, EPIPE, "a write"},
                 {Kind::write, EINTR, "a write"}});
}

TEST_F(SystemCallErrors, FailureOfEachReadIsHandled) {
    expect_told({{Kind::read, EIO, "a read"}, {Kind::read, EINTR, "a read"}});
}

TEST_F(SystemCallErrors, FailureOfEachOpenAndStatIsHandled) {
    expect_told({{Kind::open, EMFILE, "opening"}, {Kind::look, EACCES, "looking at a file"}});
}

TEST_F(SystemCallErrors, FailureOfEachFileCompletionIsHandled) {
    expect_told({{Kind::close, EIO, "closing"},
                 {Kind::fsync, EIO, "fsync"},
                 {Kind::rename, EIO, "renaming"},
                 {Kind::mode, EPERM, "taking over the mode"},
                 {Kind::copy, EMFILE, "a second descriptor"}});
}

// Half of the transfer is done, and the remainder in another call: no data is lost, and no error is reported.
TEST_F(SystemCallErrors, PartialWritesAndReadsLoseNoData) {
    for (const Kind kind : {Kind::write, Kind::read}) {
        for (const Job& job : jobs()) {
            const Count count = sweep(job, {.kind = kind, .error = kShort});
            print_row(kind == Kind::write ? "a write, in part" : "a read, in part", job.name, count);
            EXPECT_GT(count.struck, 0U) << job.name;
            EXPECT_EQ(count.struck, count.attempts) << job.name;
            EXPECT_EQ(count.done, count.attempts) << job.name;
            for (const std::string& wrong : count.wrong) ADD_FAILURE() << job.name << ": " << wrong;
        }
    }
}

TEST_F(SystemCallErrors, ReportsFullDisk) {
    const Job job = job_named("gcode2lua");
    const Outcome found = run(job, {.kind = Kind::write, .which = 1, .error = ENOSPC});
    EXPECT_EQ(found.err, "gcode2lua: cannot write 'wheel.lua': No space left on device\n");
    EXPECT_EQ(found.files, job.files);
}

const Job kTranslation{"translation", {"gcode2lua", "long.nc"}, {{"long.nc", long_program()}}};

TEST_F(SystemCallErrors, ReportsFullDiskOfTemporaryFile) {
    const Outcome found = run(kTranslation, {.kind = Kind::write, .which = 1, .error = ENOSPC});
    EXPECT_EQ(found.status, 2);
    EXPECT_EQ(found.err,
              "gcode2lua: the temporary file for the Lua cannot be written: No space left on device\n");
}

// The program is read more than once; an error in any reading is not taken for the end of the program.
TEST_F(SystemCallErrors, RejectsPartlyReadProgram) {
    const Outcome found = run(kTranslation, {.kind = Kind::read, .which = 5, .error = EIO});
    EXPECT_EQ(found.status, 2);
    EXPECT_EQ(found.out, "");
    EXPECT_EQ(found.err, "gcode2lua: long.nc: cannot be read to its end: Input/output error\n");
}

TEST_F(SystemCallErrors, RejectsUnreadableScript) {
    const Job job{"script", {"gsim-run", "script.lua"}, {{"script.lua", "print(1)\n"}}};
    const Outcome found = run(job, {.kind = Kind::read, .which = 1, .error = EIO});
    EXPECT_EQ(found.status, 2);
    EXPECT_EQ(found.err, "gsim-run: script.lua: cannot be read to its end: Input/output error\n");
}

// The text of a long script lies in a temporary file while it runs.
TEST_F(SystemCallErrors, RunStopsIfTextOfScriptIsLost) {
    const Job job = job_named("gsim-run, a long program");
    const Outcome is_clean = run(job, {.kind = Kind::read});
    const std::uint64_t reads = is_clean.calls[static_cast<std::size_t>(Kind::read)];
    const Outcome found = run(job, {.kind = Kind::read, .which = reads, .error = EIO});
    EXPECT_EQ(found.status, 2) << found.out;
    EXPECT_NE(found.out.find("the temporary file for the Lua cannot be read: Input/output error"),
              std::string::npos)
        << found.out;
}

}  // namespace
}  // namespace gsim::faults::calls_test
