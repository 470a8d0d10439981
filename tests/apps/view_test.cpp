// Page with a finished run in it (--view), from a program that is installed next to a page.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"
#include "tests/studio/engine/frames.h"

namespace gsim::apps::view_test {
namespace {

namespace fs = std::filesystem;
using studio::Frame;

constexpr const char* kPart = "G21 G90\nG0 X10\nG1 Y20 F6000\nM2\n";
const std::string kBefore = "<html>before<script type=\"application/octet-stream\" id=\"run\">";
const std::string kBehind = "</script>behind</html>\n";

class ViewOutput : public Apps {
  protected:
    /// Installs a program of its own, with a page in the folder of an installation.
    void install(const std::string& page) const {
        fs::create_directories(folder_ / "here/bin");
        fs::create_directories(folder_ / "here/share/gsim/studio");
        fs::copy_file(fs::canonical(tests::program_path("gsim-run")), folder_ / "here/bin/gsim-run");
        write("here/share/gsim/studio/view.html", page);
    }
    Ended view(const std::vector<std::string>& arguments, const std::string& input = {}) const {
        return run_program((folder_ / "here/bin/gsim-run").string(), arguments, folder_, input);
    }
    /// The messages in a page, unpacked by other programs.
    std::vector<Frame> frames(const std::string& file) const {
        const std::string page = read(file);
        EXPECT_EQ(page.substr(0, kBefore.size()), kBefore);
        EXPECT_EQ(page.substr(page.size() - kBehind.size()), kBehind);
        write("run.base64", page.substr(kBefore.size(), page.size() - kBefore.size() - kBehind.size()));
        const Ended unpacked = run_program("/bin/sh", {"-c", "base64 -d run.base64 | gunzip"}, folder_);
        EXPECT_EQ(unpacked.status, 0) << unpacked.err;
        std::vector<Frame> all;
        for (std::size_t at = 0; at < unpacked.out.size();) {
            const std::size_t size = studio::number_at(unpacked.out, at);
            all.push_back(studio::read_frame(unpacked.out.substr(at, size)));
            at += size;
        }
        return all;
    }
    static const Frame* find(const std::vector<Frame>& all, const std::string& kind) {
        for (const Frame& frame : all) {
            if (frame.is() == kind) return &frame;
        }
        return nullptr;
    }
};

const std::string kPageFile = "<html>before<!-- run -->behind</html>\n";

TEST_F(ViewOutput, HasRunSourceAndReport) {
    install(kPageFile);
    const Ended ended = view({"--quiet", "--view", "out.html", write("part.nc", kPart)});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto all = frames("out.html");
    const Frame* segments = find(all, "segments");
    ASSERT_NE(segments, nullptr);
    EXPECT_EQ(segments->column<std::uint32_t>("line"), (std::vector<std::uint32_t>{2, 3}));
    const Frame* source = find(all, "source");
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->header["name"], "part.nc");
    EXPECT_EQ(source->columns.at("text"), kPart);
    const Frame* report = find(all, "report");
    ASSERT_NE(report, nullptr);
    EXPECT_EQ(report->header["report"]["status"], "completed");
}

TEST_F(ViewOutput, HasNoSourceForProgramFromPipe) {
    install(kPageFile);
    write("stdin", "G0 X999\n");  // which is another program
    const Ended ended = view({"--quiet", "--view", "out.html", "-"}, kPart);
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto all = frames("out.html");
    EXPECT_NE(find(all, "segments"), nullptr);
    EXPECT_EQ(find(all, "source"), nullptr);
}

TEST_F(ViewOutput, HasLongSource) {
    install(kPageFile);
    std::string part = "G21 G90\n";
    while (part.size() < 5'000'000) part += "(A REMARK THAT MAKES THE PROGRAM LONGER)\n";
    part += "G0 X10\nM2\n";
    const Ended ended = view({"--quiet", "--view", "out.html", write("part.nc", part)});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto all = frames("out.html");
    const Frame* source = find(all, "source");
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->columns.at("text").size(), part.size());
}

TEST_F(ViewOutput, RejectsFileOfRobot) {
    install(kPageFile);
    write("robots.toml", "[[robot]]\nname = \"left\"\nmachine = \"left.toml\"\n");
    write("cell.lua",
          "local _ENV = require \"gsim\"\nprocess(\"a\", function() local _ENV = robot \"left\" G0{x=10} "
          "end)\n");
    const Ended machine = run_program((folder_ / "here/bin/gsim-run").string(), {"--print-machine"}, folder_);
    write("left.toml", machine.out);
    const Ended over_machine =
        view({"--quiet", "--view", "left.toml", "--robots", "robots.toml", "cell.lua"});
    EXPECT_EQ(over_machine.status, 2);
    EXPECT_EQ(read("left.toml"), machine.out);
    const Ended over_moves = view({"--quiet", "--view", "moves.left.jsonl", "--moves", "moves.jsonl",
                                   "--robots", "robots.toml", "cell.lua"});
    EXPECT_EQ(over_moves.status, 2) << over_moves.err;
    EXPECT_TRUE(contains(over_moves.err, "moves.left.jsonl")) << over_moves.err;
}

TEST_F(ViewOutput, IsSameForRepeatedRun) {
    install(kPageFile);
    const std::string part = write("part.nc", kPart);
    EXPECT_EQ(view({"--quiet", "--view", "one.html", part}).status, 0);
    EXPECT_EQ(view({"--quiet", "--view", "other.html", part}).status, 0);
    EXPECT_EQ(read("one.html"), read("other.html"));
}

TEST_F(ViewOutput, ReportsHowToBuildMissingPage) {
    install(kPageFile);
    fs::remove_all(folder_ / "here/share");
    const Ended ended = view({"--view", "out.html", write("part.nc", kPart)});
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(contains(ended.err, "--view requires the Studio page, which is not installed")) << ended.err;
    EXPECT_TRUE(contains(ended.err, "`make studio` builds it")) << ended.err;
    EXPECT_FALSE(exists("out.html"));
}

TEST_F(ViewOutput, RejectsPageWithoutPlaceholder) {
    install("<html></html>\n");
    const Ended ended = view({"--view", "out.html", write("part.nc", kPart)});
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(contains(ended.err, "has no placeholder for a run")) << ended.err;
}

TEST_F(ViewOutput, LeavesNoFileForRejectedProgram) {
    install(kPageFile);
    const Ended ended = view({"--quiet", "--view", "out.html", write("part.nc", "G999\n")});
    EXPECT_EQ(ended.status, 1);
    EXPECT_FALSE(exists("out.html"));
}

TEST_F(ViewOutput, ReportsFullDisk) {
    install(kPageFile);
    const Ended ended = view({"--quiet", "--view", "/dev/full", write("part.nc", kPart)});
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(contains(ended.err, "No space left on device")) << ended.err;
}

TEST_F(ViewOutput, HasAllRobotsOnOnePage) {
    install(kPageFile);
    write("robots.toml",
          "[[robot]]\nname = \"left\"\n[[robot]]\nname = \"right\"\nbase = { x_mm = 9000.0 }\n");
    write(
        "cell.lua",
        "local _ENV = require \"gsim\"\nprocess(\"a\", function() local _ENV = robot \"left\" G0{x=10} end)\n"
        "process(\"b\", function() local _ENV = robot \"right\" G0{x=20} end)\n");
    const Ended ended = view({"--quiet", "--view", "out.html", "--robots", "robots.toml", "cell.lua"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    std::vector<std::string> names;
    std::vector<double> bases_mm;
    for (const Frame& frame : frames("out.html")) {
        if (frame.is() != "scene") continue;
        names.push_back(frame.header["name"]);
        bases_mm.push_back(frame.header["scene"]["base"][12]);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"left", "right", "left", "right"}));
    EXPECT_EQ(bases_mm, (std::vector<double>{0, 9000, 0, 9000}));
}

}  // namespace
}  // namespace gsim::apps::view_test
