// Surroundings of a program: clocks that jump, a locale with commas, folders that cannot be written or are
// gone, others that write the same files.

#include <cstdlib>
#include <fstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <locale.h>
#include <sys/file.h>
#include <unistd.h>

#include "tests/build_files/build_files.h"
#include "tests/faults/jobs.h"
#include "tests/faults/sweep.h"

namespace gsim::faults::surroundings_test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kJumps = {
    fmt::format("LD_PRELOAD={}", tests::build_path("lib/test_modules/libgsim_clocks.so")),
    "ASAN_OPTIONS=verify_asan_link_order=0"};

void expect_same(const Job& job, const Outcome& found, const Outcome& is_clean) {
    EXPECT_EQ(found.ended_by, "") << job.name;
    EXPECT_EQ(found.status, is_clean.status) << job.name << found.err;
    EXPECT_EQ(found.out, is_clean.out) << job.name;
    EXPECT_EQ(found.err, is_clean.err) << job.name;
    EXPECT_EQ(found.files, is_clean.files) << job.name;
}

TEST(Clocks, ClockJumpsDoNotChangeResults) {
    for (const Job& job : jobs()) expect_same(job, run(job, {.environment = kJumps}), run(job, {}));
}

TEST(Clocks, CpuTimeLimitStopsLoop) {
    const Job job{
        "loop",
        {"gsim-run", "--json", "--max-cpu-seconds", "0.2", "--max-steps", "1000000000000", "loop.lua"},
        {{"loop.lua", "while true do local x = 1 end\n"}}};
    const Outcome found = run(job, {.environment = kJumps});
    EXPECT_EQ(found.status, 1) << found.ended_by << found.err;
    EXPECT_NE(found.out.find("--max-cpu-seconds"), std::string::npos) << found.out;
}

/// Runner of a command in a folder of its own.
class InFolder {
  public:
    explicit InFolder(const Files& files) { write_files(folder_.path(), files); }
    Ended run(const std::vector<std::string>& command,
              const std::vector<std::string>& environment = {}) const {
        return wait_for(start({.command = command,
                               .environment = environment,
                               .folder = folder_.path(),
                               .err = folder_.path() / "err"}));
    }
    std::string said() const { return read_file(folder_.path() / "err"); }
    const fs::path& path() const { return folder_.path(); }

  private:
    Folder folder_;
};

TEST(Clocks, WaitingForLockTimesOut) {
    const Job job = job_named("gsim-data set");
    const InFolder folder(job.files);
    const int lock = ::open((folder.path() / ".data.txt.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    ASSERT_EQ(::flock(lock, LOCK_EX), 0);
    std::vector<std::string> command = job.command;
    command.front() = program_path(command.front());
    command.insert(command.end(), {"--wait", "90"});
    const Ended ended = folder.run(command, kJumps);
    ::close(lock);
    EXPECT_EQ(ended.status, 2) << ended.by;
    EXPECT_NE(folder.said().find("has not finished within 90 s"), std::string::npos) << folder.said();
    EXPECT_EQ(read_file(folder.path() / "data.txt"), job.files.at("data.txt"));
}

class Locale : public testing::Test {
  protected:
    /// Makes the locale; returns false if that cannot be done.
    bool make() const {
        const InFolder folder({});
        const std::string locale_folder = (folder_.path() / kName).string();
        if (!fs::exists("/usr/bin/localedef") || !fs::exists("/usr/share/i18n/locales/de_DE")) return false;
        folder.run({"/usr/bin/localedef", "--no-archive", "-i", "de_DE", "-f", "UTF-8", locale_folder});
        return fs::exists(locale_folder + "/LC_NUMERIC");
    }
    std::vector<std::string> environment() const {
        return {"LOCPATH=" + folder_.path().string(), fmt::format("LC_ALL={}", kName),
                "LANG=", "LANGUAGE=de"};
    }
    static constexpr const char* kName = "de_DE.UTF-8";
    Folder folder_;
};

TEST_F(Locale, DecimalCommaDoesNotAppearInOutput) {
    if (!make()) GTEST_SKIP() << "no localedef, or not the sources of de_DE (the package locales)";
    const InFolder check({});
    ASSERT_EQ(check.run({"/bin/bash", "-c", "[[ $(printf %.1f 1,5) == 1,5 ]]"}, environment()).status, 0)
        << "the locale that was made has no commas";
    for (const Job& job : jobs())
        expect_same(job, run(job, {.environment = environment()}), run(job, {.environment = {"LC_ALL=C"}}));
}

// --- Folders ---

/// Returns a command prefix for a user bound by file modes: the user of the test, or `nobody` in place of
/// root. Empty if that cannot be done.
std::vector<std::string> as_ordinary_user() {
    if (::geteuid() != 0) return {"/usr/bin/env"};
    const std::vector<std::string> user = {"/usr/bin/setpriv", "--reuid=65534", "--regid=65534",
                                           "--clear-groups"};
    std::vector<std::string> probe = user;
    probe.insert(probe.end(), {program_path("gsim"), "--version"});
    const InFolder folder({});
    if (!fs::exists(user.front())) return {};
    return folder.run(probe).status == 0 ? user : std::vector<std::string>();
}

bool writes_a_file(const Job& job) {
    const Outcome is_clean = run(job, {});
    return is_clean.files != job.files;
}

TEST(Folders, ReadOnlyFolderStaysUnchanged) {
    const std::vector<std::string> user = as_ordinary_user();
    if (user.empty()) GTEST_SKIP() << "root cannot be anyone else here";
    for (const Job& job : jobs()) {
        if (!writes_a_file(job)) continue;
        const Folder folder;
        const fs::path work = folder.path() / "work";
        write_files(work, job.files);
        fs::create_directories(work);
        fs::permissions(folder.path(), fs::perms(0777));
        fs::permissions(work, fs::perms(0555));
        std::vector<std::string> command = user;
        command.push_back(program_path(job.command.front()));
        command.insert(command.end(), job.command.begin() + 1, job.command.end());
        const Ended ended =
            wait_for(start({.command = command, .folder = work, .err = folder.path() / "err"}));
        EXPECT_EQ(ended.status, 2) << job.name << ended.by;
        const std::string said = read_file(folder.path() / "err");
        EXPECT_TRUE(said.find("Permission denied") != std::string::npos || job.command[1] == "--no-confine")
            << job.name << ": " << said;
        EXPECT_EQ(read_files(work), job.files) << job.name;
        fs::permissions(work, fs::perms(0777));
    }
}

/// A command in a folder that is gone.
std::vector<std::string> in_lost_folder(const std::vector<std::string>& command) {
    std::vector<std::string> full = {"/bin/sh", "-c",
                                     "mkdir gone && cd gone && rmdir ../gone && exec \"$0\" \"$@\""};
    full.push_back(program_path(command.front()));
    full.insert(full.end(), command.begin() + 1, command.end());
    return full;
}

TEST(Folders, MissingWorkingFolderIsReportedOrNotNeeded) {
    const std::string wheel = tests::source_path("samples/wheel.nc");
    const std::string path = tests::source_path("samples/wheel.path.json");
    const InFolder folder({});
    const auto out = [&](const std::string& name) { return (folder.path() / name).string(); };
    const std::vector<std::vector<std::string>> absolute = {
        {"gsim-run", "--quiet", wheel, "--moves", out("moves"), "--report", out("report")},
        {"gcode2lua", wheel, "-o", out("lua")},
        {"path2gcode", path, "-o", out("nc")},
        {"gsim-check", wheel},
        {"gsim-data", out("data"), "set", "--create", "VARIABLE", "500", "VALUE=3"}};
    for (const auto& command : absolute)
        EXPECT_EQ(folder.run(in_lost_folder(command)).status, 0) << command.front() << ": " << folder.said();
    const Files full = read_files(folder.path());
    const std::vector<std::vector<std::string>> relative = {
        {"gsim-run", "--quiet", wheel, "--moves", "moves"},
        {"gsim-run", "--quiet", wheel, "--variables", "kept"},
        {"gcode2lua", wheel, "-o", "lua"},
        {"path2gcode", path, "-o", "nc"},
        {"gsim-check", "wheel.nc"},
        {"gsim-data", "data", "list"}};
    for (const auto& command : relative) {
        const InFolder other({});
        EXPECT_EQ(other.run(in_lost_folder(command)).status, 2) << command.front() << ": " << other.said();
        EXPECT_NE(other.said().find("No such file or directory"), std::string::npos) << other.said();
        EXPECT_EQ(read_files(other.path()).size(), 1U) << "what it said alone";
    }
    Files now = read_files(folder.path());
    EXPECT_EQ(now.at("lua"), full.at("lua"));
}

// Two programs of different length, written by many runs under the same names: each file is completely one of
// theirs.
TEST(Folders, ConcurrentRunsLeaveCompleteFiles) {
    const std::string samples = tests::source_path("samples/");
    const std::vector<std::vector<std::string>> commands = {
        {"gcode2lua", "PART", "-o", "part.lua"},
        {"gsim-run", "--quiet", "PART", "--moves", "moves", "--report", "report", "--record", "path"},
        {"gsim-check", "PART", "--sarif", "found"}};
    for (const auto& command : commands) {
        const auto of = [&](const std::string& part) {
            std::vector<std::string> full = command;
            for (std::string& word : full) word = word == "PART" ? part : word;
            return full;
        };
        const Files parts = {{"a.nc", "G0 X100\nM2\n"},
                             {"b.nc", "G0 X10\nG1 X110 F3000\nG1 X20\nG1 X50\nM2\n"}};
        const Outcome one = run({"a", of("a.nc"), parts}, {}), other = run({"b", of("b.nc"), parts}, {});
        const InFolder folder(parts);
        const Folder said;
        constexpr int kRuns = 64;
        std::vector<int> processes;
        for (int i = 0; i < kRuns; ++i) {
            std::vector<std::string> full = of(i % 2 == 0 ? "a.nc" : "b.nc");
            full.front() = program_path(full.front());
            const fs::path err = said.path() / std::to_string(i);
            processes.push_back(start({.command = full, .folder = folder.path(), .err = err}));
        }
        for (int i = 0; i < kRuns; ++i) {
            const Ended ended = wait_for(processes[static_cast<std::size_t>(i)]);
            EXPECT_EQ(ended.status, 0)
                << command.front() << ended.by << ": " << read_file(said.path() / std::to_string(i));
        }
        const Files found = read_files(folder.path());
        EXPECT_EQ(found.size(), one.files.size()) << "nothing is left over";
        for (const auto& [name, text] : found)
            EXPECT_TRUE(text == one.files.at(name) || text == other.files.at(name)) << name;
    }
}

}  // namespace
}  // namespace gsim::faults::surroundings_test
