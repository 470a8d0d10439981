// Dialect and units of programs by the machine file; names of controls; hints and warnings.

#include "base/text/json.h"
#include "tests/apps/run_program.h"

namespace gsim::apps::machine_language_test {
namespace {

using nlohmann::json;

constexpr const char* kMachine =
    "[machine]\nname = \"m\"\ninverse = \"gantry\"\n"
    "[[axis]]\nletter = \"X\"\nkind = \"linear\"\nmax_speed_mm_s = 100.0\ndirection = \"x\"\n"
    "[[axis]]\nletter = \"Y\"\nkind = \"linear\"\nmax_speed_mm_s = 100.0\ndirection = \"y\"\n"
    "[[axis]]\nletter = \"Z\"\nkind = \"linear\"\nmax_speed_mm_s = 100.0\ndirection = \"z\"\n";

class MachineLanguage : public Apps {
  protected:
    std::string machine(const std::string& program) const {
        return write("m.toml", std::string(kMachine) + "[program]\n" + program);
    }
    json report(std::vector<std::string> arguments, int status = 0) const {
        arguments.push_back("--json");
        const Ended e = gsim_run(arguments);
        EXPECT_EQ(e.status, status) << e.err;
        return text::try_parse_json<json>(e.out);
    }
};

constexpr const char* kNgc = "#<side> = 10\ng1 x#<side> f600\nm2\n";

TEST_F(MachineLanguage, UsesDialectOfMachine) {
    write("part.ngc", kNgc);
    const std::string m = machine("dialect = \"linuxcnc\"\n");
    EXPECT_NEAR(report({"--machine", m, "part.ngc"})["bounds"]["X"]["max"].get<double>(), 10, 1e-9);
    EXPECT_EQ(gcode2lua({"part.ngc"}).status, 1);
    const Ended e = gcode2lua({"--machine", m, "part.ngc"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(gcode2lua({"--machine", m, "--dialect", "ab9", "part.ngc"}).status, 1) << "--dialect wins";
}

// The translator reads that table alone: other content may be for a machine that it does not know.
TEST_F(MachineLanguage, TranslationReadsOnlyProgramTable) {
    write("part.ngc", kNgc);
    write("odd.toml", "robot = { arms = 7 }\n[program]\ndialect = \"rs274ngc\"\n");
    EXPECT_EQ(gcode2lua({"--machine", "odd.toml", "part.ngc"}).status, 0);
    EXPECT_EQ(gsim_run({"--machine", "odd.toml", "part.ngc"}).status, 2);
    write("odd.toml", "[program]\nunits = \"feet\"\n");
    EXPECT_EQ(gcode2lua({"--machine", "odd.toml", "part.ngc"}).err,
              "gcode2lua: odd.toml:2:9: 'units' must be \"mm\" or \"inch\"\n");
    write("odd.toml", "[program]\nunit = \"mm\"\n");
    EXPECT_EQ(gcode2lua({"--machine", "odd.toml", "part.ngc"}).err,
              "gcode2lua: odd.toml:2:1: unknown key 'unit' in [program]; did you mean 'units'?\n");
    write("odd.toml", "[program]\ndialect = \"fanux\"\n");
    EXPECT_EQ(gcode2lua({"--machine", "odd.toml", "part.ngc"}).err,
              "gcode2lua: 'dialect' under [program] of the machine file: unknown dialect or controller "
              "'fanux'; did you mean 'fanuc'?\n");
}

TEST_F(MachineLanguage, UnitsApplyUntilProgramChangesThem) {
    for (const auto& [dialect, line] : {std::pair{"ab9", "G1 X2 F60\nG21\nX60\nM30\n"},
                                        std::pair{"rs274ngc", "G1 X2 F60\nG21\nX60\nM2\n"}}) {
        write("part.nc", line);
        const std::string m = machine(std::string("units = \"inch\"\ndialect = \"") + dialect + "\"\n");
        const json direct = report({"--machine", m, "part.nc"});
        EXPECT_NEAR(direct["bounds"]["X"]["max"].get<double>(), 60, 1e-9) << dialect;
        // 50.8 mm and 9.2 mm at 60 in/min, which is 25.4 mm/s.
        EXPECT_NEAR(direct["cycle_time_s"].get<double>(), 60 / 25.4, 0.01) << dialect;
        ASSERT_EQ(gcode2lua({"--machine", m, "part.nc", "-o", "part.lua"}).status, 0);
        EXPECT_TRUE(contains(read("part.lua"), ".inch\"")) << read("part.lua");
        // The script says so itself, whatever machine runs it.
        const std::string metric = write("metric.toml", kMachine);
        EXPECT_EQ(report({"--machine", metric, "part.lua"})["cycle_time_s"], direct["cycle_time_s"])
            << dialect;
    }
}

TEST_F(MachineLanguage, InitialModalStateMatchesUnits) {
    write("part.nc", "G1 X[#4006] F600\nM30\n");
    const json r = report({"--machine", machine("units = \"inch\"\n"), "part.nc"});
    EXPECT_NEAR(r["bounds"]["X"]["max"].get<double>(), 20 * 25.4, 1e-9);
    write("part.ngc", "M70\nG21\nM72\nG1 X1 F60\nM2\n");
    const json restored =
        report({"--machine", machine("units = \"inch\"\ndialect = \"rs274ngc\"\n"), "part.ngc"});
    EXPECT_NEAR(restored["bounds"]["X"]["max"].get<double>(), 25.4, 1e-9);
}

TEST_F(MachineLanguage, CalledProgramInheritsUnits) {
    write("part.nc", "G21\nM98 P2\nM30\n");
    write("O0002.nc", "O2\nG1 X10 F600\nM99\n");
    const json r = report({"--machine", machine("units = \"inch\"\n"), "part.nc"});
    EXPECT_NEAR(r["bounds"]["X"]["max"].get<double>(), 10, 1e-9);
}

TEST_F(MachineLanguage, AcceptsControllerNames) {
    write("part.ngc", kNgc);
    EXPECT_EQ(gcode2lua({"--dialect", "LinuxCNC", "part.ngc"}).err, "");
    write("part.nc", "G0 X1\nM30\n");
    EXPECT_EQ(gcode2lua({"--dialect", "9/series", "part.nc"}).err, "");
    const json near = report({"--dialect", "haas", "part.nc"});
    ASSERT_EQ(near["diagnostics"].size(), 1U);
    EXPECT_EQ(near["diagnostics"][0]["code"], "dialect");
    EXPECT_TRUE(contains(near["diagnostics"][0]["text"], "programs of haas are read as ab9"))
        << near["diagnostics"];
    const Ended e = gsim_run({"--dialect", "heidenhain", "part.nc"});
    EXPECT_EQ(e.status, 2);
    EXPECT_EQ(e.err, "gsim-run: the language of Heidenhain (BEGIN PGM, L X+10 FMAX) is not supported\n");
}

TEST_F(MachineLanguage, ErrorSuggestsDialectOption) {
    write("part.nc", "G0 X1\no100 sub\no100 endsub\n");
    for (const Ended& e : {gsim_run({"part.nc"}), gcode2lua({"part.nc"})}) {
        EXPECT_EQ(e.status, 1);
        EXPECT_TRUE(contains(
            e.err, "part.nc:2: note: an O-word belongs to RS274/NGC (LinuxCNC); try --dialect rs274ngc\n"))
            << e.err;
    }
    EXPECT_FALSE(contains(gcode2lua({write("ok.nc", "G0 X1 (o100 sub)\n")}).err, "note"));
}

TEST_F(MachineLanguage, WarnsOfInchProgramReadAsMm) {
    write("haas.nc", "G0 X1.125 Y-.375\nZ.1\nG1 Z-.2501 F10.\nX2.4375 F45.\nM30\n");
    const Ended e = gcode2lua({"haas.nc"});
    EXPECT_EQ(e.status, 0);
    EXPECT_TRUE(contains(e.err, "haas.nc: warning: the program has neither G20 nor G21")) << e.err;
    const std::string said = write("metric.toml", kMachine);
    EXPECT_TRUE(
        contains(report({"--machine", said, "haas.nc"})["diagnostics"].dump(), "seems to be in inches"));
    EXPECT_FALSE(contains(report({"--machine", machine("units = \"mm\"\n"), "haas.nc"})["diagnostics"].dump(),
                          "inches"));
    EXPECT_FALSE(contains(
        report({"--machine", machine("units = \"inch\"\n"), "haas.nc"})["diagnostics"].dump(), "inches"));
}

TEST_F(MachineLanguage, PrintsAndReadsProgramTable) {
    const std::string m = machine("dialect = \"haas\"\nunits = \"inch\"\n");
    const Ended e = gsim_run({"--machine", m, "--print-machine"});
    EXPECT_TRUE(contains(e.out, "[program]\ndialect = \"haas\"\nunits = \"inch\"\n")) << e.out;
    write("again.toml", e.out);
    EXPECT_EQ(gsim_run({"--machine", "again.toml", "--print-machine"}).out, e.out);
}

}  // namespace
}  // namespace gsim::apps::machine_language_test
