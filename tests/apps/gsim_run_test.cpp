// gsim-run from the outside: exit statuses, reports, limits, and error messages.

#include <cmath>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::gsim_run_test {
namespace {

using nlohmann::json;

class GsimRun : public Apps {
  protected:
    // The report of a run with --json.
    json report(std::vector<std::string> arguments, int status = 0, const std::string& input = {}) {
        arguments.push_back("--json");
        const Ended e = gsim_run(arguments, input);
        EXPECT_EQ(e.status, status) << e.err;
        return text::try_parse_json<json>(e.out);
    }
};

TEST_F(GsimRun, PrintsTextReport) {
    const Ended e = gsim_run({write("part.nc", "G1 X100 F6000\nM2\n")});
    EXPECT_EQ(e.status, 0);
    EXPECT_TRUE(contains(e.out, "part.nc")) << e.out;
    EXPECT_TRUE(contains(e.out, "1.2")) << e.out;  // 100 mm at 100 mm/s and 490.33 mm/s2: 1.204 s
    EXPECT_EQ(e.err, "");
    EXPECT_EQ(gsim_run({"part.nc", "--quiet"}).out, "");
}

TEST_F(GsimRun, PrintsJsonReport) {
    const json r = report({write("part.nc", "G1 X100 F6000\nM8\nG4 P1\nM2\n")});
    EXPECT_EQ(r["program"], "part.nc");
    EXPECT_EQ(r["status"], "completed");
    EXPECT_TRUE(r["alarm"].is_null());
    EXPECT_NEAR(r["cycle_time_s"].get<double>(), 1 + 100.0 / 490.33 + 1, 1e-6);
    EXPECT_NEAR(r["time"]["dwell_s"].get<double>(), 1, 1e-9);
    EXPECT_NEAR(r["length"]["feed_mm"].get<double>(), 100, 1e-9);
    EXPECT_EQ(r["blocks"], 4);
    EXPECT_EQ(r["events"][0]["kind"], "jet_on");
    EXPECT_EQ(r["events"][0]["line"], 2);
    EXPECT_NEAR(r["bounds"]["X"]["max"].get<double>(), 100, 1e-9);
}

// 100 mm at 100 mm/s, a dwell, and 10 mm on which full speed is not reached.
TEST_F(GsimRun, ExplainsTimeByLimit) {
    const std::string part = write("part.nc", "G1 X100 F6000\nG4 P1\nX110\nM2\n");
    const json r = report({part, "--explain"});
    const double line_s = 1 + 100.0 / 490.33;
    const double short_s = 2 * std::sqrt(10 / 490.33);
    ASSERT_EQ(r["time_by_limit"].size(), 3U) << r;
    EXPECT_EQ(r["time_by_limit"][0]["limited_by"], "feed");
    EXPECT_NEAR(r["time_by_limit"][0]["time_s"].get<double>(), line_s, 1e-6);
    EXPECT_EQ(r["time_by_limit"][1]["limited_by"], "dwell");
    EXPECT_NEAR(r["time_by_limit"][2]["time_s"].get<double>(), short_s, 1e-6);
    EXPECT_NEAR(r["lower_bound_s"].get<double>(), line_s + 1 + short_s, 1e-6);
    EXPECT_EQ(r["slowest"][0]["limited_by"], "feed");
    const std::string text = gsim_run({part, "--explain"}).out;
    EXPECT_TRUE(contains(text, "time by cause")) << text;
    EXPECT_TRUE(contains(text, "(the program takes 1.00 times this)")) << text;
    EXPECT_FALSE(contains(gsim_run({part}).out, "lower bound"));
    EXPECT_FALSE(report({part}).contains("time_by_limit"));
    EXPECT_FALSE(report({part}).contains("lower_bound_s"));
}

TEST_F(GsimRun, AlarmReturnsStatusOneAndEarlierMoves) {
    const json r = report({write("part.nc", "G0 X100\n\nG0 X5000\n"), "--stop-at-first"}, 1);
    EXPECT_EQ(r["status"], "alarm");
    EXPECT_EQ(r["alarm"]["line"], 3);
    EXPECT_EQ(r["alarm"]["file"], "part.nc");
    EXPECT_EQ(r["alarm"]["axis"], "X");
    EXPECT_EQ(r["alarm"]["value"], 5000);
    EXPECT_EQ(r["alarm"]["limit"], 1828.8);
    EXPECT_EQ(r["moves"], 1);
    const Ended quiet = gsim_run({"part.nc", "--quiet", "--stop-at-first"});
    EXPECT_EQ(quiet.status, 1);
    EXPECT_TRUE(quiet.err.starts_with("part.nc:3: alarm: ")) << quiet.err;
    EXPECT_EQ(gsim_run({"part.nc", "--quiet"}).err,
              "part.nc:3: axis X moves to 5000 mm, 3171.2 mm past its limit of 1828.8 mm\n");
}

TEST_F(GsimRun, DoesNotRunProgramWithErrors) {
    const Ended e = gsim_run({write("part.nc", "G0 X1\nG999\n")});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "part.nc:2:1: error: ")) << e.err;
    const json r = report({"part.nc"}, 1);
    EXPECT_EQ(r["status"], "alarm");
    EXPECT_EQ(r["moves"], 0);
}

TEST_F(GsimRun, StopsAtTimeBlockStepAndMemoryLimits) {
    const std::string part = write("part.nc", "G0 X100\nX0\nM99\n");
    EXPECT_EQ(report({part, "--passes", "1000", "--max-time", "5"}, 1)["status"], "stopped");
    EXPECT_EQ(report({part, "--passes", "1000", "--max-blocks", "10"}, 1)["blocks"], 10);
    const std::string endless = write("endless.lua", "while true do end\n");
    EXPECT_EQ(report({endless, "--max-steps", "100000"}, 1)["status"], "stopped");
    const std::string hungry = write("hungry.lua", "local t = {} for i = 1, 1e9 do t[i] = i end\n");
    const json r = report({hungry, "--memory", "16"}, 1);
    EXPECT_EQ(r["status"], "stopped");
    EXPECT_TRUE(contains(r["alarm"]["message"], "16 MB"));
}

TEST_F(GsimRun, RunsRequestedPassesOfEndlessProgram) {
    const std::string part = write("part.nc", "G0 X100\nX0\nM99\n");
    EXPECT_TRUE(contains(gsim_run({part}).out,
                         "passes      1 of the main program, which jumps back to its start; --passes runs "
                         "more\n  jump at   part.nc:3\n"));
    const json r = report({part, "--passes", "2"});
    EXPECT_EQ(r["passes"].dump(), R"({"count":2,"file":"part.nc","line":3,"to_block":null})");
    EXPECT_EQ(r["moves"], 4);
    const Ended check = run_program(tests::program_path("gsim"), {"check", part}, folder_);
    EXPECT_EQ(check.status, 0);
    EXPECT_TRUE(
        check.out.starts_with("part.nc:3: note: passes: 1 of the main program, which jumps back to its "
                              "start; --passes runs more\n"));
    EXPECT_NE(gsim_run({part, "--passes", "0"}).status, 0);
}

TEST_F(GsimRun, AppliesBlockDeleteAndOptionalStop) {
    const std::string part = write("part.nc", "G0 X1\n/X2\nM1\n");
    EXPECT_EQ(report({part})["moves"], 2);
    EXPECT_EQ(report({part, "--block-delete"})["moves"], 1);
    EXPECT_TRUE(report({part})["events"][0].contains("detail"));
    EXPECT_FALSE(report({part, "--optional-stop"})["events"][0].contains("detail"));
}

TEST_F(GsimRun, ReadsPrintedAndOtherMachineFiles) {
    const std::string machine = write("machine.toml", gsim_run({"--print-machine"}).out);
    const std::string part = write("part.nc", "G55 G0 X100\n");
    EXPECT_EQ(report({part, "--machine", machine}), report({part}));
    EXPECT_EQ(gsim_run({"--machine", machine, "--print-machine"}).out, read(machine));
    const json router = report(
        {write("short.nc", "G0 X10\n"), "--machine", tests::source_path("samples/machines/router3.toml")});
    EXPECT_NE(router["machine"], report({"short.nc"})["machine"]);
    EXPECT_FALSE(router["bounds"].contains("B"));
}

TEST_F(GsimRun, ReplacesLuaLibrary) {
    namespace fs = std::filesystem;
    fs::copy(tests::source_path("lua_lib"), folder_ / "lib", fs::copy_options::recursive);
    write("lib/common/switches.lua",
          read("lib/common/switches.lua") +
              "use(\"core/words\", \"before\")(\"M8\", \"times\", function() core.event(\"mine\") end)\n");
    const std::string part = write("part.nc", "M8\n");
    EXPECT_EQ(report({part, "--lua-lib", "lib"})["events"][0]["kind"], "mine");
    write("lib/init.lua", "nonsense\n");
    const Ended broken = gsim_run({part, "--lua-lib", "lib"});
    EXPECT_EQ(broken.status, 2);
    EXPECT_TRUE(contains(broken.err, "lua_lib/init.lua:")) << broken.err;
    EXPECT_EQ(gsim_run({part, "--lua-lib", "nowhere"}).status, 2);
}

TEST_F(GsimRun, ReportsUnreadableAndUnwritableFiles) {
    const std::string part = write("part.nc", "G0 X1\n");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"missing.nc"},
                                               {"missing.lua"},
                                               {"."},
                                               {},
                                               {part, "--machine", "missing.toml"},
                                               {part, "--machine", "."},
                                               {part, "--machine", part},
                                               {part, "--machine-data", "missing.txt"},
                                               {part, "--machine-data", part},
                                               {part, "--report", "no/such/folder/r.json"},
                                               {part, "--moves", "."},
                                               {part, "--trajectory", "no/such/t.csv"},
                                               {part, "--plot", "no/such/p.svg"}}) {
        const Ended e = gsim_run(arguments);
        EXPECT_EQ(e.status, 2) << (arguments.empty() ? "" : arguments.back()) << e.err;
        EXPECT_TRUE(e.err.starts_with("gsim-run: ")) << e.err;
    }
    EXPECT_EQ(files(), 1U);
}

TEST_F(GsimRun, RejectsInvalidOptions) {
    const std::string part = write("part.nc", "G0 X1\n");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{part, "--nonsense"},
                                               {part, "--step", "0"},
                                               {part, "--step", "-1"},
                                               {part, "--max-time", "-5"},
                                               {part, "--max-time", "soon"},
                                               {part, "--max-blocks", "0"},
                                               {part, "--memory", "0"},
                                               {part, "--dialect", "klingon"},
                                               {part, "other.nc"},
                                               {part, "--report"}}) {
        const Ended e = gsim_run(arguments);
        EXPECT_EQ(e.status, 2) << arguments[1];
        EXPECT_EQ(e.out, "");
        EXPECT_NE(e.err, "");
    }
    EXPECT_EQ(gsim_run({"--help"}).status, 0);
    EXPECT_TRUE(gsim_run({"--version"}).out.starts_with("gsim-run "));
}

TEST_F(GsimRun, EndsNormallyOnOddInput) {
    EXPECT_EQ(report({write("empty.nc", "")})["status"], "completed");
    EXPECT_EQ(report({write("empty.lua", "")})["status"], "completed");
    EXPECT_EQ(report({"-"}, 0, "")["status"], "completed");
    for (const std::string& input :
         {std::string("\0\1\2", 3), std::string("\x1bLua", 4), std::string(50'000, '('),
          std::string("local x ="), std::string("-- \xff\n\xfe")}) {
        const Ended nc = gsim_run({"-", "--json"}, input);
        EXPECT_TRUE(nc.status == 0 || nc.status == 1) << nc.status;
        write("odd.lua", input);
        const Ended lua = gsim_run({"odd.lua", "--json"});
        EXPECT_TRUE(lua.status == 0 || lua.status == 1) << lua.status;
        EXPECT_FALSE(text::try_parse_json<json>(lua.out).is_discarded()) << lua.out;
    }
}

TEST_F(GsimRun, ScriptOutputStaysOutOfReport) {
    const Ended e = gsim_run({write("part.lua", "print(\"hello\", 5)\nG0{x=1}\n"), "--json"});
    EXPECT_EQ(e.status, 0);
    EXPECT_EQ(e.err, "hello\t5\n");
    EXPECT_FALSE(text::try_parse_json<json>(e.out).is_discarded());
}

}  // namespace
}  // namespace gsim::apps::gsim_run_test
