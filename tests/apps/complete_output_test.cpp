// Standard output that cannot be written: each program says so, with its reason and its exit status.

#include <filesystem>

#include <fmt/format.h>

#include "tests/apps/output_options.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::whole_output_test {
namespace {

const std::string kSamples = tests::source_path("samples/");
constexpr const char* kFull = "cannot write standard output: No space left on device\n";

class CompleteOutput : public Apps {
  protected:
    /// Runs a line of the shell, in which $G is gsim.
    Ended shell(const std::string& line) const {
        return run_program("/bin/sh", {"-c", fmt::format("G='{}'; {}", tests::program_path("gsim"), line)},
                           folder_);
    }
    void SetUp() override {
        if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    }
    const std::string part_ = write("part.nc", "G0 X100\nG1 X110 F3000\n");
    const std::string wrong_ = write("wrong.nc", "G0 X5000\n");
};

TEST_F(CompleteOutput, EachProgramReportsFullDisk) {
    const std::string long_data = [] {
        std::string text = "NCFILE\nVARIABLE\n";
        for (int i = 500; i < 1000; ++i) text += fmt::format("{} {}.25\n", i, i);
        return text + "ENDFILE\n";
    }();
    write("d.txt", long_data);
    const std::string wheel = kSamples + "wheel.nc";
    std::vector<std::string> commands = {"run " + wheel,
                                         "run --json " + wheel,
                                         "run --print-machine",
                                         "run --check-machine " + kSamples + "machines/af5.toml",
                                         "run --quiet --sarif - " + wheel,
                                         "check part.nc",
                                         "check --json part.nc",
                                         "check --sarif - part.nc",
                                         "translate " + wheel,
                                         "translate --print-language",
                                         "write " + kSamples + "wheel.path.json",
                                         "path --speed 400 --kerf 1 " + kSamples + "plate.svg",
                                         "data d.txt list",
                                         "data d.txt --json list",
                                         "data d.txt get VARIABLE 500",
                                         "data d.txt convert --json",
                                         "help",
                                         "help run",
                                         "run --help",
                                         "manual run",
                                         "completion bash",
                                         "completion zsh",
                                         "completion fish",
                                         "--version",
                                         "run --version"};
    for (const std::string& option : output_options())
        commands.push_back(fmt::format("run --quiet {} - {}", option, wheel));
    for (const std::string& command : commands) {
        const Ended ended = shell("$G " + command + " >/dev/full");
        EXPECT_EQ(ended.status, 2) << command;
        const std::size_t reported = ended.err.find(kFull);
        EXPECT_NE(reported, std::string::npos) << command << ": " << ended.err;
        EXPECT_EQ(ended.err.find(kFull, reported + 1), std::string::npos) << "told once: " << command;
    }
}

TEST_F(CompleteOutput, KeepsErrorStatusIfReportIsLost) {
    const Ended ended = shell("$G run --json wrong.nc >/dev/full");
    EXPECT_EQ(ended.status, 1);
    EXPECT_EQ(ended.err, kFull);
    EXPECT_EQ(shell("$G check wrong.nc >/dev/full").status, 1);
}

TEST_F(CompleteOutput, WritesFilesIfReportIsLost) {
    EXPECT_EQ(shell("$G run --json part.nc --moves m.jsonl >/dev/full").status, 2);
    EXPECT_TRUE(contains(read("m.jsonl"), "\"n\":2"));
}

TEST_F(CompleteOutput, ReportsNameOfFileOnFullDisk) {
    std::vector<std::string> options = output_options();
    options.emplace_back("--sarif");
    for (const std::string& option : options) {
        const Ended ended = shell("$G run --quiet part.nc " + option + " /dev/full");
        EXPECT_EQ(ended.status, 2) << option;
        EXPECT_TRUE(contains(ended.err, "cannot write '/dev/full': No space left on device\n")) << ended.err;
    }
    for (const std::string command :
         {"translate part.nc -o /dev/full", "run --quiet part.nc --save-machine-data /dev/full"}) {
        const Ended ended = shell("$G " + command);
        EXPECT_EQ(ended.status, 2) << command;
        EXPECT_TRUE(contains(ended.err, "cannot write '/dev/full': No space left on device\n")) << ended.err;
    }
}

TEST_F(CompleteOutput, ReportsAndRemovesFileAboveSizeLimit) {
#ifdef GSIM_COUNTS_COVERAGE
    GTEST_SKIP() << "the counts of the program are files, too";
#endif
    const std::string limited = "ulimit -f 1; exec $G run --quiet --step 0.001 part.nc ";
    const Ended ended = shell(limited + "--trajectory t.csv --moves m.jsonl");
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "gsim-run: cannot write 't.csv': File too large\n");
    const Ended plot = shell(limited + "--plot p.svg");
    if (contains(plot.err, "cannot run gnuplot")) GTEST_SKIP() << plot.err;
    EXPECT_EQ(plot.status, 2);
    EXPECT_TRUE(plot.err.starts_with("gsim-run: cannot ")) << plot.err;
    EXPECT_EQ(files(), 2U) << "moves neither: the files of a run belong together";
}

TEST_F(CompleteOutput, ReportsPictureNotDrawnByGnuplot) {
    write("bin/gnuplot", "#!/bin/sh\nexit 0\n");
    const Ended ended =
        shell("chmod +x bin/gnuplot; PATH=$PWD/bin:$PATH; $G run --quiet --plot p.svg part.nc");
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "gsim-run: cannot draw 'p.svg': gnuplot created no picture\n");
    EXPECT_FALSE(exists("p.svg"));
}

TEST_F(CompleteOutput, KeepsReportOutOfFilesIfStdoutIsClosed) {
    const Ended ended = shell("$G run --json part.nc --moves m.jsonl >&-");
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "cannot write standard output: Bad file descriptor\n");
    EXPECT_TRUE(read("m.jsonl").starts_with("{\"n\":1")) << "without the report in it";
    EXPECT_FALSE(contains(read("m.jsonl"), "cycle_time_s"));
    EXPECT_EQ(shell("$G run --quiet part.nc >&-").status, 0) << "nothing to print";
}

TEST_F(CompleteOutput, IgnoresFullStandardError) {
    EXPECT_EQ(shell("$G run part.nc --moves - 2>/dev/full").status, 0);
    EXPECT_EQ(shell("$G run nowhere.nc 2>/dev/full").status, 2);
    EXPECT_EQ(shell("$G run wrong.nc 2>&-").status, 1);
    EXPECT_EQ(shell("$G check part.nc nowhere.nc 2>/dev/full").status, 2);
}

// The output is more than a pipe holds, to a reader that does not read.
TEST_F(CompleteOutput, EndsAtBrokenPipeAndLeavesNoFiles) {
    const std::string run = "$G run --quiet --step 0.0001 --trajectory - --moves m.jsonl part.nc";
    const Ended killed = shell("{ " + run + "; echo $? >status; } | true");
    EXPECT_EQ(read("status"), "141\n") << "by the signal, as other programs";
    EXPECT_EQ(killed.err, "");
    EXPECT_FALSE(exists("m.jsonl"));
    EXPECT_EQ(files(), 3U) << "no temporary file is left";
    const Ended ignored = shell("trap '' PIPE; { " + run + "; echo $? >status; } | true");
    EXPECT_EQ(read("status"), "2\n");
    EXPECT_EQ(ignored.err, "gsim-run: cannot write standard output: Broken pipe\n");
    EXPECT_EQ(files(), 3U);
}

}  // namespace
}  // namespace gsim::apps::whole_output_test
