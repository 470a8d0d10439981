// Several robots in one run: the sample cell, files of their own, and errors.

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/machines/bare_machine.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::robots_test {
namespace {

using nlohmann::json;

const std::string kSample = tests::source_path("samples/cell/");

class Robots : public Apps {
  protected:
    Ended run_sample(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"--robots", kSample + "robots.toml", kSample + "cell.lua"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return gsim_run(arguments);
    }
    json run(const std::string& script) const {
        write("r.toml",
              "[[robot]]\nname = \"left\"\n[[robot]]\nname = \"right\"\ndialect = \"rs274ngc\"\n"
              "[[conveyor]]\nname = \"belt\"\ndirection = { y = 1.0 }\nspeed_mm_s = 50.0\n");
        const Ended e = gsim_run({"--robots", "r.toml", write("cell.lua", script), "--json"});
        json report = text::try_parse_json<json>(e.out);
        EXPECT_FALSE(report.is_discarded()) << e.err;
        return report;
    }
};

TEST_F(Robots, SampleGivesSameReportEachTime) {
    const Ended first = run_sample({"--json", "--moves", "m.jsonl", "--trajectory", "t.csv"});
    ASSERT_EQ(first.status, 0) << first.err << first.out;
    const std::string left = read("m.left.jsonl");
    const std::string right = read("t.right.csv");
    EXPECT_FALSE(left.empty());
    const Ended second = run_sample({"--json", "--moves", "m.jsonl", "--trajectory", "t.csv"});
    EXPECT_EQ(first.out, second.out);
    EXPECT_EQ(read("m.left.jsonl"), left);
    EXPECT_EQ(read("t.right.csv"), right);
    EXPECT_FALSE(exists("m.jsonl"));
    const json report = text::parse_json<json>(first.out);
    EXPECT_EQ(report["robots"].size(), 2U);
    EXPECT_EQ(report["robots"][1]["name"], "right");
    EXPECT_GT(report["robots"][1]["idle_s"], 10);
    EXPECT_EQ(report["processes"].size(), 4U);
    EXPECT_TRUE(contains(run_sample({}).out, "--- robot right"));
}

TEST_F(Robots, EachIsRecordedInSeparatePath) {
    write("two.toml", "[[robot]]\nname = \"left\"\n[[robot]]\nname = \"right\"\n");
    write("two.lua",
          "process('l', function() local _ENV = robot 'left' F(600) G1{x=10} end)\n"
          "process('r', function() local _ENV = robot 'right' F(600) G1{y=20} end)\n");
    const Ended ended = gsim_run({"--robots", "two.toml", "two.lua", "--record", "p.json", "--quiet"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    for (const auto& [robot, position] : {std::pair("left", "[10,0,0]"), {"right", "[0,20,0]"}}) {
        const json path = text::try_parse_json<json>(read(fmt::format("p.{}.json", robot).c_str()));
        ASSERT_FALSE(path.is_discarded()) << robot;
        EXPECT_TRUE(contains(path.dump(), position)) << path.dump(2);
    }
    const Ended sample = run_sample({"--quiet", "--record", "s.json"});
    EXPECT_EQ(sample.status, 1) << "as of one robot";
    EXPECT_TRUE(contains(sample.err, "no path is recorded: the program tracks a conveyor")) << sample.err;
}

TEST_F(Robots, ReportSettingsNotImported) {
    write("mill.ini",
          "[EMC]\nMACHINE = mill\n[KINS]\nKINEMATICS = trivkins coordinates=X\nJOINTS = 1\n[TRAJ]\n"
          "COORDINATES = X\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 100\n[HAL]\nHALFILE = a.hal\n[AXIS_X]\n"
          "MIN_LIMIT = -10\nMAX_LIMIT = 10\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 500\n");
    write("r.toml", "[[robot]]\nname = \"left\"\nmachine = \"mill.ini\"\n");
    const Ended ended = gsim_run({"--robots", "r.toml", write("cell.lua", "process('l', function() end)\n")});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, "lines that are not imported")) << ended.err;
}

TEST_F(Robots, EachHasSeparateModalStateAndClock) {
    write("right.ngc", "o<hop> sub\nG91 G0 X[#1]\no<hop> endsub\no<hop> call [30]\nM2\n");
    const json report =
        run("local l = robot 'left'\n"
            "process('l', function() l.G91() l.G0{x=10} l.G0{x=10} signal('go') end)\n"
            "process('r', function() local _ENV = robot 'right' wait_until 'go'\n"
            "  run 'right.ngc' G0{x=5} end)\n");
    ASSERT_EQ(report["status"], "completed") << report["alarm"];
    EXPECT_EQ(report["robots"][0]["bounds"]["X"]["max"], 20);
    EXPECT_EQ(report["robots"][1]["bounds"]["X"]["max"], 35);  // incremental still
    EXPECT_EQ(report["robots"][1]["idle_s"], report["robots"][0]["cycle_time_s"]);
    EXPECT_EQ(report["cycle_time_s"], report["robots"][1]["cycle_time_s"]);
}

TEST_F(Robots, FollowConveyor) {
    const json report =
        run("local belt = conveyor 'belt'\n"
            "process('r', function() local _ENV = robot 'right' F(6000)\n"
            "  belt.wait_for(100) signal('start', belt.position()) track 'belt'\n"
            "  G1{x=100, y=0} track(nil) G53() G1{y=0} end)\n");
    ASSERT_EQ(report["status"], "completed") << report["alarm"];
    EXPECT_NEAR(report["signals"][0]["t_s"].get<double>(), 2, 1e-9);
    EXPECT_NEAR(std::stod(report["signals"][0]["value"].get<std::string>()), 100, 1e-9);
    // At Y0 of the belt the robot is where the belt has moved to.
    EXPECT_GT(report["robots"][1]["bounds"]["Y"]["max"], 150);
}

// A plate on the belt comes 500 mm towards the left robot, at 50 mm/s and from 2 s on at 25, while that one
// has long planned its move.
TEST_F(Robots, BodyOnConveyorHitsRobotAtRightTime) {
    write("cell.toml", R"([cell]
name = "belt"
[[object]]
name = "plate"
attached_to = "belt"
shape = { box_mm = [4000.0, 0.1, 400.0] }
frame = { y_mm = -500.0 }
[[shape]]
name = "tip"
on = "tool"
shape = { sphere_mm = 10.0 }
)");
    write("bare.toml", without_bodies(read(tests::source_path("samples/machines/af5.toml"))));
    write("belt.toml",
          "[[robot]]\nname = \"left\"\nmachine = \"bare.toml\"\ncell = \"cell.toml\"\n[[robot]]\nname = "
          "\"right\"\n"
          "base = { x_mm = 3000.0, roll_deg = 90.0 }\ncell = \"cell.toml\"\n"
          "[[conveyor]]\nname = \"belt\"\ndirection = { y = 1.0 }\nspeed_mm_s = 50.0\n");
    const std::string script = write("cell.lua",
                                     "local _ENV = require 'gsim'\n"
                                     "process('l', function() local _ENV = robot 'left' F(600)\n"
                                     "  G1{x=300}\n"
                                     "  G1{x=310}\n"
                                     "end)\n"
                                     "device('slow', function() wait(2) conveyor('belt').speed(25) end)\n");
    const Ended e = gsim_run({"--robots", "belt.toml", script, "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = text::parse_json<json>(e.out)["robots"];
    ASSERT_EQ(robots[0]["collisions"].size(), 1U);
    EXPECT_NEAR(robots[0]["collisions"][0]["t_s"].get<double>(), 2 + (500 - 5.05 - 100) / 25, 1e-6);
    EXPECT_EQ(robots[0]["collisions"][0]["line"], 3);
    EXPECT_TRUE(robots[1]["collisions"].empty());  // in its world the belt runs along -X
}

// Rapids of 250 mm, feed moves of 100 mm, from standstill to standstill: d / v + v / a; and half a second at
// the fixture.
TEST_F(Robots, SlidesOfSampleTakeTurns) {
    const Ended e = gsim_run({"--robots", kSample + "slides.toml", kSample + "slides.lua", "--json"});
    ASSERT_EQ(e.status, 0) << e.err;
    const json report = text::parse_json<json>(e.out);
    const double rapid_s = 250 / 150.0 + 150 / 500.0;
    const double work_s = 2 * (100 / 100.0 + 100 / 500.0) + 0.5;
    // The right one waits while the left one works for the first time; later they are at it by turns.
    EXPECT_NEAR(report["robots"][0]["cycle_time_s"].get<double>(), 3 * (2 * rapid_s + work_s), 1e-9);
    EXPECT_NEAR(report["robots"][1]["idle_s"].get<double>(), work_s, 1e-9);
    EXPECT_TRUE(report["robots"][0]["collisions"].empty());
    EXPECT_EQ(report["robots"][1]["cell"]["checked"]["with_robots"], 1);
}

TEST_F(Robots, AlarmOfOneEndsRun) {
    const json report =
        run("process('l', function() local _ENV = robot 'left' wait(1)\nG1{x=9} end)\n"
            "process('r', function() local _ENV = robot 'right' for i = 1, 100 do wait(1) end end)\n");
    EXPECT_EQ(report["status"], "alarm");
    EXPECT_EQ(report["alarm"]["line"], 2);
    EXPECT_TRUE(report["robots"][1]["alarm"].is_null());
    EXPECT_TRUE(contains(run("robot 'lefd'\n")["alarm"]["message"], "did you mean 'left'?"));
    EXPECT_TRUE(
        contains(run("robot('left').run 'none.nc'\n")["alarm"]["message"], "file 'none.nc' not found"));
    EXPECT_TRUE(contains(
        run("process('l', function() track 'belt' conveyor('belt').speed(3) end)\n")["alarm"]["message"],
        "cannot change"));
}

TEST_F(Robots, RejectIncompatibleOptionsAndInvalidFile) {
    const Ended e = run_sample({"--machine", "x.toml"});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "--machine cannot be combined with --robots")) << e.err;
    write("bad.toml", "[[robot]]\nnam = 'x'\n");
    EXPECT_EQ(gsim_run({"--robots", "bad.toml", write("a.lua", "G0{x=1}")}).status, 2);
}

}  // namespace
}  // namespace gsim::apps::robots_test
