// Both programs with the options that set how G-code is read, and the files next to a program: setup scripts
// and permanent variables.

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::dialects_test {
namespace {

using nlohmann::json;

class Dialects : public Apps {
  protected:
    json report(std::vector<std::string> arguments, int status = 0) {
        arguments.push_back("--json");
        const Ended e = gsim_run(arguments);
        EXPECT_EQ(e.status, status) << e.err;
        return text::try_parse_json<json>(e.out);
    }
};

constexpr const char* kSquare =
    "#<side> = 10\no100 repeat [2]\ng91 g1 x#<side> f600\no100 endrepeat\n(debug, at #<_x>)\nm2\n";

TEST_F(Dialects, Rs274ngcRunMatchesRunOfItsLua) {
    write("part.ngc", kSquare);
    const json direct = report({"--dialect", "rs274ngc", "part.ngc"});
    EXPECT_NEAR(direct["length"]["feed_mm"].get<double>(), 20, 1e-9);
    EXPECT_EQ(direct["events"][0]["detail"], " at 20.000000");
    ASSERT_EQ(gcode2lua({"--dialect", "rs274ngc", "part.ngc", "-o", "part.lua"}).status, 0);
    const json by_lua = report({"part.lua"});  // the script says its dialect
    EXPECT_EQ(by_lua["cycle_time_s"], direct["cycle_time_s"]);
    EXPECT_EQ(by_lua["events"][0]["line"], 5);
}

TEST_F(Dialects, ReportsUnknownDialectAsUsageError) {
    EXPECT_EQ(gsim_run({"--dialect", "iso", write("part.nc", "G0 X1\n")}).status, 2);
    EXPECT_EQ(gcode2lua({"--unknown", "ignore", "part.nc"}).status, 2);
    const Ended studio =
        run_program(tests::program_path("gsim"), {"studio", "--no-browser", "--dialect", "iso"}, folder_);
    EXPECT_EQ(studio.status, 2);
    EXPECT_TRUE(contains(studio.err, "unknown dialect or controller 'iso'")) << studio.err;
}

TEST_F(Dialects, NamesOtherDialectOfUnknownCode) {
    const Ended e = gcode2lua({write("part.nc", "G38.2 Z-5 F100\n")});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "RS274/NGC supports it")) << e.err;
}

TEST_F(Dialects, OmitsAndCountsUnknownCodesOnRequest) {
    write("part.nc", "G0 X1\nM77\nM77 P3\nG234 X5\nX2\nM30\n");
    EXPECT_EQ(gcode2lua({"part.nc"}).status, 1);
    const Ended e = gcode2lua({"--unknown", "warn", "part.nc"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(e.err, "part.nc:2:1: warning: M77")) << e.err;
    EXPECT_TRUE(contains(e.err, "(2 in total)")) << e.err;
    EXPECT_FALSE(contains(e.out, "x=5")) << "what X5 means is not known without G234\n" << e.out;
    EXPECT_TRUE(contains(e.out, "move{x=2}")) << e.out;
}

TEST_F(Dialects, FindsSubroutinesOfLongProgram) {
    std::string part = "g21\no<far> call [3]\no<near> sub\ng0 x[#1 + 0.5]\no<near> endsub\n";
    for (int i = 0; i < 60000; ++i) part += "g1 y1 f1000\n";
    part += "o<near> call [8]\nm2\no<far> sub\no<near> call [#1]\ng0 z[1/0]\no<far> endsub\n";
    write("part.ngc", part);
    const json r = report({"--dialect", "rs274ngc", "part.ngc"}, 1);
    EXPECT_EQ(r["alarm"]["line"], 60010);
    EXPECT_NEAR(r["bounds"]["X"]["max"].get<double>(), 3.5, 1e-9) << "a subroutine called out of another";
}

TEST_F(Dialects, FindsSubroutineFileNextToProgram) {
    write("part.ngc", "o<hole> call [7]\n(debug, #<_value>)\nm2\n");
    write("hole.ngc", "o<hole> sub\ng0 x#1\no<hole> endsub [#1 * 2]\nm2\n");
    const json r = report({"--dialect", "rs274ngc", "part.ngc"});
    EXPECT_NEAR(r["bounds"]["X"]["max"].get<double>(), 7, 1e-9);
    EXPECT_EQ(r["events"][0]["detail"], " 14.000000");
}

TEST_F(Dialects, AlarmNamesCallChain) {
    const json r = report({write("part.nc", "O1\nM98 P2\nM2\nO2\nM98 P3\nM99\nO3\nG0 X[1/0]\nM99\n")}, 1);
    EXPECT_EQ(r["alarm"]["line"], 8);
    ASSERT_EQ(r["alarm"]["calls"].size(), 2U);
    EXPECT_EQ(r["alarm"]["calls"][0], (json{{"program", "O3"}, {"file", "part.nc"}, {"line", 5}}));
    EXPECT_EQ(r["alarm"]["calls"][1], (json{{"program", "O2"}, {"file", "part.nc"}, {"line", 2}}));
    EXPECT_TRUE(contains(gsim_run({"part.nc"}).out, "O3 at part.nc:5"));
}

TEST_F(Dialects, CallChainOmitsEndedCall) {
    write("part.ngc", "o1 sub\no1 endsub\no2 sub\no1 call\n#1=[1/0]\no2 endsub\no2 call\nm2\n");
    const json r = report({"--dialect", "rs274ngc", "part.ngc"}, 1);
    ASSERT_EQ(r["alarm"]["calls"].size(), 1U);
    EXPECT_EQ(r["alarm"]["calls"][0], (json{{"program", "o2"}, {"file", "part.ngc"}, {"line", 7}}));
}

TEST_F(Dialects, SetupScriptDefinesUserCodes) {
    write("part.nc", "M101 P2\nM30\n");
    EXPECT_EQ(gsim_run({"part.nc"}).status, 1);
    write("setup.lua", "local _ENV = require \"gsim\"\nM[101] = function(words) G4{p=words.p} end\n");
    const json r = report({"--setup", "setup.lua", "part.nc"});
    EXPECT_NEAR(r["time"]["dwell_s"].get<double>(), 2, 1e-9);
    EXPECT_EQ(gsim_run({"--setup", "none.lua", "part.nc"}).status, 2);
}

TEST_F(Dialects, StoresPermanentVariablesInFile) {
    write("part.nc", "#500=#500+1\n#1=5\nM30\n");
    EXPECT_EQ(gsim_run({"--variables", "kept.var", "part.nc"}).status, 0);
    EXPECT_EQ(read("kept.var"), "500\t1\n");
    EXPECT_EQ(gsim_run({"--variables", "kept.var", "part.nc"}).status, 0);
    EXPECT_EQ(read("kept.var"), "500\t2\n");
    write("kept.var", "500 two\n");
    const Ended e = gsim_run({"--variables", "kept.var", "part.nc"});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "kept.var:1:")) << e.err;
    EXPECT_EQ(read("kept.var"), "500 two\n") << "a file that was not understood stays as it is";
}

}  // namespace
}  // namespace gsim::apps::dialects_test
