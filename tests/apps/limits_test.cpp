// Limits that end runs with too much time or memory, wherever that is.

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::limits_test {
namespace {

using nlohmann::json;
using Limits = Apps;

constexpr const char* kAtOnce = "1e-9";
constexpr const char* kReached = "(--max-cpu-seconds)";

json stopped(const Ended& run) {
    EXPECT_EQ(run.status, 1) << run.err;
    json report = text::parse_json<json>(run.out);
    EXPECT_EQ(report["status"], "stopped");
    EXPECT_EQ(report["alarm"]["code"], "run-limit");
    EXPECT_TRUE(contains(report["alarm"]["message"], kReached)) << report["alarm"];
    return report;
}

TEST_F(Limits, CpuTimeEndsEndlessScript) {
    write("part.lua", "local n = 0\nwhile true do\n  n = n + 1\n  G0{x = n % 7}\nend\n");
    const json report = stopped(gsim_run({"part.lua", "--max-cpu-seconds", "0.2", "--json"}));
    EXPECT_EQ(report["alarm"]["file"], "part.lua");
    EXPECT_GE(report["alarm"]["line"], 2);
    EXPECT_GT(report["moves"], 0);
}

TEST_F(Limits, CpuTimeEndsSlowStringsAndProtectedCalls) {
    // Steps count from 0 again with each motion, and large values make each comparison slow.
    write("part.lua",
          "local a, b = (\"x\"):rep(1 << 26), (\"x\"):rep(1 << 26)\n"
          "while true do if a == b then G0{x=1} G0{x=0} end end\n");
    stopped(gsim_run({"part.lua", "--max-cpu-seconds", "0.2", "--json"}));
    write("caught.lua", "while true do pcall(function() while true do G0{x=1} G0{x=0} end end) end\n");
    stopped(gsim_run({"caught.lua", "--max-cpu-seconds", "0.2", "--json"}));
}

TEST_F(Limits, CpuTimeEndsTranslation) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += "G0 X" + std::to_string(i % 9) + "\n";
    write("part.nc", text + "G999\n");
    const json report =
        stopped(gsim_run({"part.nc", "--max-cpu-seconds", kAtOnce, "--json", "--report", "report.json"}));
    EXPECT_EQ(report["alarm"]["file"], "part.nc");
    const Ended standalone = gcode2lua({"part.nc", "--max-cpu-seconds", kAtOnce});
    EXPECT_EQ(standalone.status, 1);
    EXPECT_TRUE(contains(standalone.err, kReached)) << standalone.err;
    EXPECT_FALSE(contains(standalone.err, "G999")) << standalone.err;
    EXPECT_EQ(standalone.out, "");
}

TEST_F(Limits, CpuTimeAppliesToEachCheckedProgram) {
    write("part.lua", "while true do G0{x=1} G0{x=0} end\n");
    const Ended check = run_program(tests::program_path("gsim"),
                                    {"check", "part.lua", "part.lua", "--max-cpu-seconds", "0.1"}, folder_);
    EXPECT_EQ(check.status, 1);
    const std::size_t first = check.out.find(kReached);
    EXPECT_NE(check.out.find(kReached, first + 1), std::string::npos) << check.out;
}

TEST_F(Limits, CpuTimeEndsRobotRunAndPathScript) {
    write("cell.toml",
          "[[robot]]\nname = \"left\"\nmachine = \"af5\"\n[[robot]]\nname = \"right\"\nmachine = \"af5\"\n");
    write("part.lua", "while true do G0{x=1} G0{x=0} end\n");
    const Ended robots =
        gsim_run({"part.lua", "--robots", "cell.toml", "--max-cpu-seconds", "0.1", "--json"});
    EXPECT_EQ(robots.status, 1) << robots.err;
    EXPECT_TRUE(contains(robots.out, kReached)) << robots.out << robots.err;
    write("path.lua", "local n = 0\nwhile true do\n  n = n + 1\nend\n");
    const Ended path =
        run_program(tests::program_path("path2gcode"), {"path.lua", "--max-cpu-seconds", kAtOnce}, folder_);
    EXPECT_EQ(path.status, 1);
    EXPECT_TRUE(contains(path.out + path.err, "path.lua:")) << path.out << path.err;
    EXPECT_TRUE(contains(path.out + path.err, kReached)) << path.out << path.err;
}

TEST_F(Limits, RepeatedProgramIsStoredOnce) {
    std::string text;
    for (int i = 0; i < 2'000; ++i) text += "G0 X" + std::to_string(i % 9) + " Y1\n";
    write("sub.nc", text + "M30\n");
    write("part.lua", "for i = 1, 40 do run(\"sub.nc\") end\n");
    const Ended run = gsim_run({"part.lua", "--memory", "16", "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(text::parse_json<json>(run.out)["moves"], 80'000) << run.out.substr(0, 400);
}

TEST_F(Limits, MemoryErrorReportsRequestedSize) {
    write("part.lua", "local s = (\"x\"):rep(1 << 30)\n");
    const Ended run = gsim_run({"part.lua", "--memory", "64", "--json"});
    EXPECT_EQ(run.status, 1);
    const std::string message = text::parse_json<json>(run.out)["alarm"]["message"];
    EXPECT_TRUE(contains(message, "needs more memory than the run may use, 64 MB (--memory): ")) << message;
    EXPECT_TRUE(contains(message, "MB are used, and 1024.0 MB more are requested")) << message;
}

TEST_F(Limits, MemoryIncludesScriptTexts) {
    const std::string filler = "-- " + std::string(9 << 20, 'x') + "\n";
    write("part.lua", filler + "G0{x=1}\n");
    const Ended run = gsim_run({"part.lua", "--memory", "16"});
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(contains(run.err + run.out,
                         "the text of the script part.lua has 9.0 MB, which is more than half of the 16 MB"))
        << run.err;
    EXPECT_EQ(gsim_run({"part.lua", "--memory", "32", "--quiet"}).status, 0);
    write("main.lua", "require \"part\"\n");
    EXPECT_EQ(gsim_run({"main.lua", "--memory", "16", "--quiet"}).status, 1);
    write("two.lua", "-- " + std::string(6 << 20, 'x') + "\n");
    write("three.lua", "-- " + std::string(6 << 20, 'x') + "\n");
    write("main.lua", "require \"two\"\nrequire \"three\"\n");
    const Ended several = gsim_run({"main.lua", "--memory", "16", "--quiet"});
    EXPECT_EQ(several.status, 1);
    EXPECT_TRUE(contains(several.err, "the text of the script needs more memory than the run may use, 16 MB"))
        << several.err;
}

TEST_F(Limits, MemoryIncludesRecordedPathAndSignals) {
    write("part.lua", "for i = 1, 100000 do G0{x = i % 7} end\n");
    const Ended path = gsim_run({"part.lua", "--memory", "16", "--record", "path.json", "--quiet"});
    EXPECT_EQ(path.status, 1);
    EXPECT_TRUE(contains(
        path.err,
        "part.lua:1: stopped: the path of the run (--record) needs more memory than the run may use, 16 MB"))
        << path.err;
    EXPECT_TRUE(exists("path.json"));
    EXPECT_EQ(gsim_run({"part.lua", "--memory", "16", "--quiet"}).status, 0);
    write("part.lua",
          "for i = 1, 1e9 do signal(\"s\" .. i, true) if i % 1000 == 0 then G0{x = i % 7} end end\n");
    const Ended signals = gsim_run({"part.lua", "--memory", "16", "--quiet"});
    EXPECT_TRUE(contains(signals.err, "needs more memory than the run may use, 16 MB (--memory)"))
        << signals.err;
}

TEST_F(Limits, RejectsLargeVariableFile) {
    std::string text;
    while (text.size() < (5U << 20U)) text += "500 1.25\n";
    write("kept.var", text);
    write("part.nc", "G0 X1\n");
    const Ended run = gsim_run({"part.nc", "--variables", "kept.var"});
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(contains(run.err + run.out, "larger than 4 MiB")) << run.err;
}

}  // namespace
}  // namespace gsim::apps::limits_test
