// Targets that probes touch: --cell, --probe, a controller module, the recorded path.

#include <cstdio>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/machines/bare_machine.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::probe_test {
namespace {

using nlohmann::json;

/// The speed of F600, and what the machine has to brake from it.
constexpr double kBraking_mm = 10.0 * 10 / (2 * 490.33);

class Probe : public Apps {
  protected:
    std::vector<std::string> arguments(const std::string& program,
                                       const std::vector<std::string>& more) const {
        std::vector<std::string> all{write("part.ngc", program), "--dialect", "rs274ngc", "--json"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    json report(const std::string& program, const std::vector<std::string>& more, int status = 0) const {
        const Ended e = gsim_run(arguments(program, more));
        EXPECT_EQ(e.status, status) << e.err << e.out;
        return text::parse_json<json>(e.out);
    }
    static std::string debugs(const json& report) {
        std::string texts;
        for (const json& event : report["events"])
            if (event["kind"] == "debug") texts += event["detail"].get<std::string>() + "\n";
        return texts;
    }
    /// A block on the table with a ball of 10 mm on the tool, or without it.
    std::string cell(bool ball) const {
        return write("cell.toml", std::string(R"(
[cell]
name = "a block"
clearance_mm = 3.0
[[object]]
name = "block"
role = "workpiece"
shape = { box_mm = [100.0, 100.0, 100.0] }
frame = { x_mm = 250.0, y_mm = 200.0 }
)") + (ball ? "[[shape]]\nname = \"stylus\"\non = \"tool\"\nshape = { sphere_mm = 10.0 }\n" : ""));
    }
};

TEST_F(Probe, StopsAtContactWithBody) {
    const std::string program =
        "G21 F600\nG0 X50 Y200\nG38.2 X300\n(debug,%.4f#5061 #5070 #<_x>)\nG38.4 X50\n(debug,%.4f#5061 #5070 "
        "#<_x>)\nG0 X20\nM2\n";
    for (const bool ball : {true, false}) {
        const json r =
            report(program,
                   {"--machine",
                    write("bare.toml", without_bodies(read(tests::source_path("samples/machines/af5.toml")))),
                    "--cell", cell(ball)});
        const double at_mm = ball ? 195 : 200;
        EXPECT_EQ(debugs(r), fmt::format("{:.4f} 1.0000 {:.4f}\n{:.4f} 1.0000 {:.4f}\n", at_mm,
                                         at_mm + kBraking_mm, at_mm, at_mm - kBraking_mm));
        EXPECT_TRUE(r["collisions"].empty()) << r["collisions"];
        EXPECT_TRUE(r["clearances"].empty()) << r["clearances"];
        EXPECT_TRUE(r["warnings"].empty()) << r["warnings"];
    }
}

// The nozzle of the machine that is built in, 7.14 mm wide.
TEST_F(Probe, UsesMachineToolIfCellHasNone) {
    const json r =
        report("G21 F600\nG0 X50 Y200\nG38.2 X300\n(debug,%.4f#5061)\nG0 X20\nM2\n", {"--cell", cell(false)});
    EXPECT_EQ(debugs(r), "196.4300\n");
    EXPECT_TRUE(r["collisions"].empty()) << r["collisions"];
}

TEST_F(Probe, FindsSamePositionInRotatedInchFrame) {
    const json r = report(
        "G20 F20\nG10 L2 P1 X1 Y1 R90\nG53 G0 X1.9685 Y7.874\nG38.2 Y-20\n(debug,%.4f#5062 "
        "#5070)\nM2\n",
        {"--cell", cell(true)});
    // Y of the program runs along -X of the machine: its value is 1 - 195/25.4.
    EXPECT_EQ(debugs(r), fmt::format("{:.4f} 1.0000\n", 1 - 195 / 25.4));
}

TEST_F(Probe, MoveBeyondContactCollides) {
    const json r =
        report("G21 F600\nG0 X50 Y200\nG38.2 X300\nG1 X210\nG0 X20\nM2\n",
               {"--machine",
                write("bare.toml", without_bodies(read(tests::source_path("samples/machines/af5.toml")))),
                "--cell", cell(true)},
               1);
    ASSERT_EQ(r["collisions"].size(), 1U);
    EXPECT_EQ(r["collisions"][0]["line"], 4);
    EXPECT_EQ(r["collisions"][0]["kind"], "penetrating");
}

TEST_F(Probe, CollidesWithBodyIfContactIsDisabled) {
    const std::string program = "G21 F600\nG0 X50 Y200\nG38.3 X300\n(debug,%.4f#5061 #5070)\nM2\n";
    EXPECT_EQ(debugs(report(program, {"--cell", cell(true), "--probe", "none"}, 1)), "300.0000 0.0000\n");
    EXPECT_EQ(debugs(report(program, {"--cell", cell(true), "--probe", "x=100"})), "100.0000 1.0000\n");
}

TEST_F(Probe, RaisesAlarmWithoutContactInCell) {
    const json r = report("G21 F600\nG0 X50 Y200\nG38.2 X100\nM2\n", {"--cell", cell(true)}, 1);
    EXPECT_EQ(r["alarm"]["message"], "G38.2 has reached its end, but the probe has not made contact");
    EXPECT_EQ(r["alarm"]["line"], 3);
}

// The program moves the block, and the probe finds it at the new position.
TEST_F(Probe, FindsBodyAtMovedFrame) {
    const std::string script = write("part.lua", R"(local _ENV = require "gsim.rs274ngc"
G21() F(600) G0{x=50, y=200}
local _, pose = rrs.GetCellFrame("block")
pose[1][4] = 350
rrs.ModifyCellFrame("block", pose)
G38_2{x=400}
DEBUG("%.4f", v[5061])
)");
    const Ended e = gsim_run({script, "--cell", cell(true), "--json"});
    ASSERT_EQ(e.status, 0) << e.err << e.out;
    EXPECT_EQ(debugs(text::parse_json<json>(e.out)), "295.0000\n");
}

TEST_F(Probe, OptionErrorReportsValidValues) {
    const std::string program = "G21 F600\nG38.2 X30\nM2\n";
    const std::string accepts =
        "--probe must be none, or the position of a plane that stops probes, as x=, y= or z= in mm of "
        "machine coordinates (z=-3.2), not '";
    for (const std::string value : {"z", "z=", "z=1mm", "a=1", "all", "z=nan", "z=inf", "=3"}) {
        const Ended e = gsim_run(arguments(program, {"--probe", value}));
        EXPECT_EQ(e.status, 2);
        EXPECT_EQ(text::parse_json<json>(e.out)["diagnostics"][0]["text"], accepts + value + "'");
    }
    EXPECT_EQ(report(program, {"--probe", "X=+2.5"})["status"], "completed");
    const Ended arm =
        gsim_run({write("part.ngc", program), "--machine", tests::source_path("samples/machines/arm6.toml"),
                  "--dialect", "rs274ngc", "--probe", "z=1"});
    EXPECT_EQ(arm.status, 2);
    EXPECT_EQ(arm.err, "gsim-run: --probe: the machine has no linear axis Z\n");
    const Ended robots =
        gsim_run({write("part.lua", ""), "--robots", write("r.toml", ""), "--probe", "none"});
    EXPECT_EQ(robots.err, "gsim-run: --probe cannot be combined with --robots\n");
}

TEST_F(Probe, CheckAcceptsOption) {
    const std::string part = write("part.ngc", "G21 F600\nG38.2 X30\nM2\n");
    const auto check = [&](const std::string& value) {
        return run_program(tests::program_path("gsim"),
                           {"check", "--dialect", "rs274ngc", "--probe", value, part}, folder_);
    };
    EXPECT_EQ(check("x=20").status, 0);
    const Ended nothing = check("none");
    EXPECT_EQ(nothing.status, 1);
    EXPECT_TRUE(contains(nothing.out, "G38.2 has reached its end, but the probe has not made contact"));
}

TEST_F(Probe, RecordedPathEndsAtStopPosition) {
    const Ended e = gsim_run({write("part.ngc", "G21 F600\nG38.2 X300\nG1 X0\nM2\n"), "--dialect", "rs274ngc",
                              "--probe", "x=100", "--record", "-"});
    ASSERT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(e.out, fmt::format("{:.6f}", 100 + kBraking_mm))) << e.out;
}

// A module is stopped at the end of the step in which it touches; ours brakes as the planner in process does.
TEST_F(Probe, StopsControllerModule) {
    const std::string program = "G21 F600\nG38.2 X300\n(debug,%.4f#5061 #5070 #<_x>)\nM2\n";
    const json r = report(program, {"--probe", "x=100", "--rcs", tests::default_module_path()});
    double trip_mm = 0;
    double found = 0;
    double stop_mm = 0;
    const std::string text = debugs(r);
    ASSERT_EQ(std::sscanf(text.c_str(), "%lf %lf %lf", &trip_mm, &found, &stop_mm), 3) << text;
    EXPECT_NEAR(trip_mm, 100, 1e-4);
    EXPECT_EQ(found, 1);
    EXPECT_GE(stop_mm, 100 + kBraking_mm - 1e-3);
    EXPECT_LE(stop_mm, 100 + kBraking_mm + 0.02);  // two steps of 1 ms at 10 mm/s
}

TEST_F(Probe, RaisesAlarmIfModuleCannotStop) {
    const json r =
        report("G21 F600\nG38.2 X300\nM2\n",
               {"--probe", "x=100", "--rcs", tests::build_path("lib/test_modules/small_module.so")}, 1);
    EXPECT_EQ(r["alarm"]["message"],
              "this controller cannot stop a probe at the contact: it has no StopMotion");
}

}  // namespace
}  // namespace gsim::apps::probe_test
