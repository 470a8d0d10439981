// Limits, zones and the process from the outside: exit statuses, remedies, gsim check.

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::violations_test {
namespace {

using nlohmann::json;

const std::string kRouter = tests::source_path("samples/machines/router3.toml");
const std::string kOutsideProgram = "G54 M3 S1000\nG0 X100 Y10\nG1 X-12.5 F1000\nX50\nM30\n";

class Violations : public Apps {
  protected:
    json report(std::vector<std::string> arguments, int status) {
        arguments.push_back("--json");
        const Ended e = gsim_run(arguments);
        EXPECT_EQ(e.status, status) << e.err << e.out;
        return text::try_parse_json<json>(e.out);
    }
    Ended check(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "check");
        return run_program(tests::program_path("gsim"), arguments, folder_);
    }
};

TEST_F(Violations, OneRunReportsViolationAndSuggestedFix) {
    const json r = report({"--machine", kRouter, write("off.nc", kOutsideProgram)}, 1);
    EXPECT_EQ(r["status"], "violations");
    EXPECT_TRUE(r["alarm"].is_null());
    EXPECT_EQ(r["violation_count"], 1);
    const json& first = r["violations"][0];
    EXPECT_EQ(first["file"], "off.nc");
    EXPECT_EQ(first["line"], 3);
    EXPECT_EQ(first["axis"], "X");
    EXPECT_EQ(first["amount"], 12.5);
    EXPECT_EQ(first["offset"], "G54");
    EXPECT_EQ(r["valid_until_s"], first["t_s"]);
    EXPECT_EQ(r["suggested_fix"],
              text::parse_json<json>(R"([{"offset": "G54", "axis": "X", "shift_mm": 12.5}])"));
    EXPECT_TRUE(contains(gsim_run({"--machine", kRouter, "off.nc"}).out,
                         "G54 X +12.5 mm would bring the complete program within the limits\n"));
    EXPECT_EQ(report({"--machine", kRouter, "--stop-at-first", "off.nc"}, 1)["status"], "alarm");
}

TEST_F(Violations, SuggestedFixRemovesViolation) {
    write("off.nc", kOutsideProgram);
    const json moved =
        report({"--machine", kRouter, "--dialect", "rs274ngc", "--variables", write("v.var", "5221 0.1\n"),
                write("inch.nc", "G20 M3 S9\nG0 X0.1\nG1 X-1 F40\nM2\n")},
               1);
    // G54 X is 0.1 inch in the variables: X-1 is -22.86 mm.
    EXPECT_EQ(moved["suggested_fix"],
              text::parse_json<json>(R"([{"offset": "G54", "axis": "X", "shift_mm": 22.86}])"));
    write("data.txt", "NCFILE\nOFFSET\n54 12.5 0 0\nENDFILE\n");
    const Ended repeated = gsim_run({"--machine", kRouter, "--machine-data", "data.txt", "off.nc"});
    EXPECT_EQ(repeated.status, 0) << repeated.out;
}

TEST_F(Violations, NoFixIfShiftCausesOtherViolation) {
    // The part is as wide as the range, moves in machine coordinates do not shift, G92 refers to the
    // machine's position.
    for (const char* program : {"G0 X-5\nG0 X600\nM30\n", "G53 G0 X-5\nM30\n", "G90 G0 X-5\nX599\nM30\n",
                                "G10 L2 P1 X-5\nG0 X0\nM30\n"}) {
        const json r = report({"--machine", kRouter, "--dialect", "rs274ngc", write("p.nc", program)}, 1);
        EXPECT_EQ(r["status"], "violations") << program;
        EXPECT_EQ(r["suggested_fix"], json::array()) << program;
    }
}

TEST_F(Violations, AreMarkedInMoves) {
    write("off.nc", kOutsideProgram);
    gsim_run({"--machine", kRouter, "--moves", "m.jsonl", "off.nc"});
    const std::string moves = read("m.jsonl");
    EXPECT_TRUE(contains(moves, R"("line":3,"kind":"linear","to":{"X":-12.5,)"));
    EXPECT_TRUE(contains(moves, R"("beyond":["X"]})"));
    EXPECT_EQ(moves.find("beyond"), moves.rfind("beyond"));
}

TEST_F(Violations, CheckReportsThem) {
    write("off.nc", kOutsideProgram);
    write("jet.nc", "M8\nG1 X10 F1000\nG0 X20\nM9\nM30\n");
    const Ended off = check({"--machine", kRouter, "off.nc"});
    EXPECT_EQ(off.status, 1);
    EXPECT_EQ(off.out,
              "off.nc:3: error: axis X moves to -12.5 mm, 12.5 mm past its limit of 0 mm\noff.nc: note: G54 "
              "X +12.5 mm would bring the complete program within the limits\n");
    const Ended jet = check({"jet.nc"});
    EXPECT_EQ(jet.status, 1);
    EXPECT_EQ(jet.out, "jet.nc:3: warning: a rapid move with the jet on\n");
    EXPECT_EQ(gsim_run({"jet.nc"}).status, 0);
    EXPECT_TRUE(contains(gsim_run({"jet.nc"}).out, "warning: jet.nc:3: a rapid move with the jet on\n"));
}

TEST_F(Violations, AreReportedForRobots) {
    write("robots.toml", "[[robot]]\nname = \"left\"\nmachine = \"" + kRouter + "\"\n");
    const Ended e = gsim_run({"--robots", "robots.toml", write("p.lua", "G0{x=-5} G0{x=10}"), "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json r = text::try_parse_json<json>(e.out);
    EXPECT_EQ(r["status"], "violations");
    EXPECT_EQ(r["violation_count"], 1);
    EXPECT_EQ(r["robots"][0]["violations"][0]["amount"], 5);
}

TEST_F(Violations, RejectsProcessWordsOfNoDialect) {
    const auto machine = [&](const std::string& on) {
        std::string text = gsim_run({"--print-machine"}).out;
        const std::size_t at = text.find("on = [\"M8\"]");
        return write("m.toml", text.replace(at, 11, "on = [" + on + "]"));
    };
    const auto error = [&](const std::string& on) {
        return gsim_run({"--machine", machine(on), write("p.nc", "G0 X1\nM30\n")}).err;
    };
    EXPECT_EQ(error("\"M13\""),
              "gsim-run: m.toml: [process]: M13 is not a code of ab9 or rs274ngc; user codes are M100 to "
              "M199, in ab9 to M999\n");
    EXPECT_EQ(error("\"M8 P1\""), "gsim-run: m.toml: [process]: M8 does not accept the words in M8 P1\n");
    EXPECT_EQ(error("\"M62 P0\", \"M64 P0\""),
              "gsim-run: [process]: the jet is switched on by M62 P0, M64 P0, which ab9 does not support\n");
    EXPECT_EQ(error("\"M8\", \"M3\", \"M62 P0\", \"M101\""), "");
}

TEST_F(Violations, ReportsProcessLengthOfRs274ngcProgram) {
    const std::string program = "G21\nG0 X10\nM8\nG1 X60 F1000\nM9\nG0 X0\nM2\n";
    EXPECT_EQ(report({"--dialect", "rs274ngc", write("p.ngc", program)}, 0)["length"]["process_on_mm"], 50);
}

}  // namespace
}  // namespace gsim::apps::violations_test
