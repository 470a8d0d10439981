// gcode2lua from the outside: options, files, and leftover files.

#include "tests/apps/run_program.h"

namespace gsim::apps::gcode2lua_test {
namespace {

class Gcode2lua : public Apps {};

TEST_F(Gcode2lua, WritesLuaToStandardOutput) {
    const Ended e = gcode2lua({write("part.nc", "G0 X1\nG1 X2 F100\n")});
    EXPECT_EQ(e.status, 0);
    EXPECT_TRUE(contains(e.out, "\nG0{x=1}\n")) << e.out;
    EXPECT_TRUE(contains(e.out, "from part.nc")) << e.out;
    EXPECT_EQ(e.err, "");
}

TEST_F(Gcode2lua, ReadsStandardInput) {
    const Ended dash = gcode2lua({"-"}, "G0 X1\n");
    const Ended bare = gcode2lua({}, "G0 X1\n");
    EXPECT_EQ(dash.status, 0);
    EXPECT_EQ(dash.out, bare.out);
    EXPECT_TRUE(contains(dash.out, "from stdin")) << dash.out;
}

TEST_F(Gcode2lua, ProducesSameOutputEachTime) {
    write("part.nc", "G0 X1\n#1=2\nM98 P5\nO5\nM99\n");
    EXPECT_EQ(gcode2lua({"part.nc"}).out, gcode2lua({"part.nc"}).out);
}

TEST_F(Gcode2lua, ReturnsStatusOneAndNoLuaOnError) {
    const Ended e = gcode2lua({write("part.nc", "G0 X1\nG0 X1 X2\nG999\n")});
    EXPECT_EQ(e.status, 1);
    EXPECT_EQ(e.out, "");
    EXPECT_TRUE(contains(e.err, "part.nc:2:7: error: ")) << e.err;
    EXPECT_TRUE(contains(e.err, "part.nc:3:1: error: ")) << e.err;  // it continues with the next block
    EXPECT_TRUE(contains(e.err, "  G0 X1 X2\n")) << e.err;
}

TEST_F(Gcode2lua, FailedRunKeepsOldFile) {
    write("out.lua", "old");
    EXPECT_EQ(gcode2lua({write("bad.nc", "G999\n"), "-o", "out.lua"}).status, 1);
    EXPECT_EQ(read("out.lua"), "old");
    EXPECT_EQ(files(), 2U);
    EXPECT_EQ(gcode2lua({write("good.nc", "G0 X1\n"), "-o", "out.lua"}).status, 0);
    EXPECT_EQ(read("out.lua"), gcode2lua({"good.nc"}).out);
    EXPECT_EQ(files(), 3U);
}

TEST_F(Gcode2lua, CheckWritesNothing) {
    const Ended good = gcode2lua({write("good.nc", "G0 X1\n"), "--check", "-o", "out.lua"});
    EXPECT_EQ(good.status, 0);
    EXPECT_EQ(good.out, "");
    EXPECT_FALSE(exists("out.lua"));
    EXPECT_EQ(gcode2lua({write("bad.nc", "G999\n"), "--check"}).status, 1);
}

TEST_F(Gcode2lua, AnnotateShowsSource) {
    const std::string part = write("part.nc", "N10 G0 X1 (go)\n");
    EXPECT_FALSE(contains(gcode2lua({part}).out, "N10 G0 X1 (go)"));
    const Ended e = gcode2lua({part, "--annotate"});
    EXPECT_TRUE(contains(e.out, "N10 G0 X1 (go)")) << e.out;
}

TEST_F(Gcode2lua, StopsAfterMaxErrors) {
    std::string program;
    for (int i = 0; i < 50; ++i) program += "G999\n";
    const Ended e = gcode2lua({write("part.nc", program), "--max-errors", "3"});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "part.nc:3:"));
    EXPECT_FALSE(contains(e.err, "part.nc:5:")) << e.err;
}

TEST_F(Gcode2lua, ReadsAliasesOfMachineData) {
    write("machine.txt", "NCFILE\nALIAS\nJETON M08\nENDFILE\n");
    const Ended e = gcode2lua({write("part.nc", "JETON\n"), "--machine-data", "machine.txt"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(e.out, "\nM8()\n")) << e.out;
    EXPECT_EQ(gcode2lua({"part.nc"}).status, 1);
}

TEST_F(Gcode2lua, ReportsUnreadableAndUnwritableFiles) {
    const std::string part = write("part.nc", "G0 X1\n");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"missing.nc"},
                                               {"."},
                                               {part, "--machine-data", "missing.txt"},
                                               {part, "--machine-data", "."},
                                               {part, "-o", "no/such/folder/out.lua"},
                                               {part, "-o", "."}}) {
        const Ended e = gcode2lua(arguments);
        EXPECT_EQ(e.status, 2) << arguments.back();
        EXPECT_EQ(e.out, "");
        EXPECT_TRUE(e.err.starts_with("gcode2lua: ")) << e.err;
    }
}

TEST_F(Gcode2lua, RejectsInvalidOptions) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--nonsense"},
                                               {"--max-errors", "0"},
                                               {"--max-errors", "many"},
                                               {"--dialect", "klingon"},
                                               {"a.nc", "b.nc"},
                                               {"-o"}}) {
        const Ended e = gcode2lua(arguments);
        EXPECT_EQ(e.status, 2) << arguments.front();
        EXPECT_NE(e.err, "");
        EXPECT_EQ(e.out, "");
    }
}

TEST_F(Gcode2lua, PrintsHelpAndVersion) {
    const Ended help = gcode2lua({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_TRUE(contains(help.out, "--annotate"));
    const Ended version = gcode2lua({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_TRUE(version.out.starts_with("gcode2lua ")) << version.out;
}

TEST_F(Gcode2lua, EndsNormallyOnOddInput) {
    for (const std::string& input :
         {std::string(), std::string("%"), std::string("\0\0\0", 3), std::string("\xff\xfe\x00G0", 5),
          std::string(100'000, '['), std::string(100'000, 'X'), std::string(200'000, '\n'), std::string("O1"),
          std::string("(open"), std::string("G0 X1\x1a"), std::string("\r\r\r")}) {
        const Ended e = gcode2lua({"-"}, input);
        EXPECT_TRUE(e.status == 0 || e.status == 1) << e.status << input.substr(0, 10);
        EXPECT_EQ(e.status == 0, !e.out.empty());
    }
    EXPECT_EQ(gcode2lua({"-"}, "").status, 0);
}

}  // namespace
}  // namespace gsim::apps::gcode2lua_test
