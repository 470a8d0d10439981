// Files that programs read, change and write back, and files that many write at once.

#include <filesystem>

#include <fmt/format.h>

#include "base/os/file_lock.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::kept_files_test {
namespace {

const std::string kData = "NCFILE\nVARIABLE\nENDFILE\n";

class PersistentFiles : public Apps {
  protected:
    Ended shell(const std::string& line) const {
        return run_program("/bin/sh", {"-c", fmt::format("G='{}'; {}", tests::program_path("gsim"), line)},
                           folder_);
    }
    /// A lock that the test itself has.
    os::FileLock lock(const std::string& name) const {
        auto got = os::FileLock::get(folder_ / name, std::chrono::milliseconds(0));
        EXPECT_TRUE(got);
        return *std::move(got);
    }
    std::string rejection(const std::string& name) const {
        return fmt::format(
            "cannot change '{}': another program is changing it, and has not finished within 0 s (its lock "
            "is '{}')\n",
            name, (std::filesystem::canonical(folder_) / ("." + name + ".lock")).string());
    }
    const std::string counts_ = write("counts.nc", "#500=#500+1\nM2\n");
};

TEST_F(PersistentFiles, KeepAllConcurrentChanges) {
    write("d.txt", kData);
    const Ended ended = shell(
        "for i in $(seq 500 579); do $G data --wait 300 d.txt set VARIABLE $i VALUE=$i || echo $i & done; "
        "wait");
    EXPECT_EQ(ended.out + ended.err, "");
    const std::string text = read("d.txt");
    for (int i = 500; i < 580; ++i) EXPECT_TRUE(contains(text, fmt::format("\n{0}  {0}\n", i))) << i;
    EXPECT_EQ(files(), 2U) << "no lock and no temporary file is left";
}

TEST_F(PersistentFiles, CountAllConcurrentRuns) {
    const Ended ended = shell(
        "for i in $(seq 20); do $G run --quiet --wait 300 --variables v counts.nc || echo $i & done; wait");
    EXPECT_EQ(ended.out + ended.err, "");
    EXPECT_EQ(read("v"), "500\t20\n");
    write("d.txt", "NCFILE\nVARIABLE\n500 0\nENDFILE\n");
    EXPECT_EQ(
        shell(
            "for i in $(seq 20); do $G run --quiet --wait 300 --machine-data d.txt --save-machine-data d.txt "
            "counts.nc || echo $i & done; wait")
            .err,
        "");
    EXPECT_TRUE(contains(read("d.txt"), "\n500 20\n")) << read("d.txt");
    EXPECT_EQ(files(), 3U);
}

TEST_F(PersistentFiles, RejectFileLockedByOtherProgram) {
    write("d.txt", kData);
    const os::FileLock data = lock("d.txt"), variables = lock("v");
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"set", "VARIABLE", "500", "VALUE=1"},
                                               {"reset-all"},
                                               {"convert", "--inch"},
                                               {"convert", "--from-json", "x.json"}}) {
        std::vector<std::string> arguments{"d.txt", "--wait", "0"};
        arguments.insert(arguments.end(), command.begin(), command.end());
        const Ended ended = gsim_data(arguments);
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.err, "gsim-data: " + rejection("d.txt"));
    }
    EXPECT_EQ(read("d.txt"), kData);
    EXPECT_EQ(gsim_data({"d.txt", "list"}).status, 0) << "reading goes on";
    write("tool.tbl", "T1 P1 D3 Z1\n");
    EXPECT_EQ(gsim_data({"import", "tool.tbl", "--wait", "0", "-o", "d.txt"}).err,
              "gsim-data: " + rejection("d.txt"));
    const Ended run = gsim_run({"--quiet", "--wait", "0", "--variables", "v", counts_});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "gsim-run: " + rejection("v"));
    EXPECT_FALSE(exists("v"));
    EXPECT_EQ(gsim_run({"--quiet", "--wait", "0", "--save-machine-data", "d.txt", counts_}).err,
              "gsim-run: " + rejection("d.txt"))
        << "written, though not read";
}

TEST_F(PersistentFiles, StayCompleteAfterConcurrentRuns) {
    write("part.nc", "G0 X100\nG1 X110 F3000\nG3 X100 Y10 I-10\n");
    ASSERT_EQ(gsim_run({"--quiet", "--moves", "one.jsonl", "--report", "one.json", "part.nc"}).status, 0);
    const Ended ended = shell(
        "for i in $(seq 64); do $G run --quiet --moves m.jsonl --report r.json part.nc || echo $i & done; "
        "wait");
    EXPECT_EQ(ended.out + ended.err, "");
    EXPECT_EQ(read("m.jsonl"), read("one.jsonl"));
    EXPECT_EQ(read("r.json"), read("one.json"));
    EXPECT_EQ(files(), 6U);
}

}  // namespace
}  // namespace gsim::apps::kept_files_test
