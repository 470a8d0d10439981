// Several robots in one run: the sample cell, files of their own, and what is refused.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/apps/bare_machine.h"
#include "tests/apps/run_program.h"

namespace gsim::apps::robots_test {
namespace {

using nlohmann::json;

const std::string kSample = GSIM_SOURCE "/samples/cell/";

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
        json report = json::parse(e.out, nullptr, false);
        EXPECT_FALSE(report.is_discarded()) << e.err;
        return report;
    }
};

TEST_F(Robots, TheSampleGivesTheSameReportEachTime) {
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
    const json report = json::parse(first.out);
    EXPECT_EQ(report["robots"].size(), 2U);
    EXPECT_EQ(report["robots"][1]["name"], "right");
    EXPECT_GT(report["robots"][1]["idle_s"], 10);
    EXPECT_EQ(report["processes"].size(), 4U);
    EXPECT_TRUE(holds(run_sample({}).out, "--- robot right"));
}

TEST_F(Robots, EachIsRecordedInAPathOfItsOwn) {
    write("two.toml", "[[robot]]\nname = \"left\"\n[[robot]]\nname = \"right\"\n");
    write("two.lua",
          "process('l', function() local _ENV = robot 'left' F(600) G1{x=10} end)\n"
          "process('r', function() local _ENV = robot 'right' F(600) G1{y=20} end)\n");
    const Ended ended = gsim_run({"--robots", "two.toml", "two.lua", "--record", "p.json", "--quiet"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    for (const auto& [robot, position] : {std::pair("left", "[10,0,0]"), {"right", "[0,20,0]"}}) {
        const json path = json::parse(read(fmt::format("p.{}.json", robot).c_str()), nullptr, false);
        ASSERT_FALSE(path.is_discarded()) << robot;
        EXPECT_TRUE(holds(path.dump(), position)) << path.dump(2);
    }
    const Ended sample = run_sample({"--quiet", "--record", "s.json"});
    EXPECT_EQ(sample.status, 1) << "as of one robot";
    EXPECT_TRUE(holds(sample.err, "no path is recorded: the program tracks a conveyor")) << sample.err;
}

TEST_F(Robots, EachHasItsOwnWordsAndClock) {
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

TEST_F(Robots, AConveyorIsFollowed) {
    const json report =
        run("local belt = conveyor 'belt'\n"
            "process('r', function() local _ENV = robot 'right' F(6000)\n"
            "  belt.wait_for(100) signal('start', belt.position()) track 'belt'\n"
            "  G1{x=100, y=0} track(nil) G53() G1{y=0} end)\n");
    ASSERT_EQ(report["status"], "completed") << report["alarm"];
    EXPECT_NEAR(report["signals"][0]["t_s"].get<double>(), 2, 1e-9);
    EXPECT_NEAR(std::stod(report["signals"][0]["value"].get<std::string>()), 100, 1e-9);
    // At Y0 of the belt it is where the belt has gone.
    EXPECT_GT(report["robots"][1]["bounds"]["Y"]["max"], 150);
}

// A plate on the belt comes 500 mm towards the left robot, at 50 mm/s and from 2 s on at 25, while that one
// has long planned its move.
TEST_F(Robots, WhatRidesOnAConveyorHitsARobotAtItsTime) {
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
    write("bare.toml", without_bodies(read(GSIM_SOURCE "/samples/machines/af5.toml")));
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
    const json robots = json::parse(e.out)["robots"];
    ASSERT_EQ(robots[0]["collisions"].size(), 1U);
    EXPECT_NEAR(robots[0]["collisions"][0]["t_s"].get<double>(), 2 + (500 - 5.05 - 100) / 25, 1e-6);
    EXPECT_EQ(robots[0]["collisions"][0]["line"], 3);
    EXPECT_TRUE(robots[1]["collisions"].empty());  // in whose world the belt runs along -X
}

/// A slide along X with a ball of 40 mm at its tool: ramps of 500 mm/s^2.
const char* const kSlide = R"([machine]
name = "slide"
inverse = "gantry"
[path]
max_feed_mm_s = 100.0
max_acceleration_mm_s2 = 500.0
[process]
kind = "spindle"
on = ["M3"]
off = ["M5"]
[[axis]]
letter = "X"
kind = "linear"
min_mm = 0.0
max_mm = 600.0
max_speed_mm_s = 150.0
max_acceleration_mm_s2 = 500.0
direction = "x"
[[axis]]
letter = "Y"
kind = "linear"
min_mm = 0.0
max_mm = 400.0
max_speed_mm_s = 150.0
max_acceleration_mm_s2 = 500.0
direction = "y"
[[axis]]
letter = "Z"
kind = "linear"
min_mm = -120.0
max_mm = 0.0
max_speed_mm_s = 60.0
max_acceleration_mm_s2 = 300.0
direction = "z"
[[shape]]
name = "ball"
on = "tool"
shape = { sphere_mm = 40.0 }
)";

class TwoSlides : public Robots {
  protected:
    /// The right one stands 700 mm further on and comes towards the left one, `y_mm` beside it.
    Ended meet(double y_mm, const std::vector<std::string>& more = {"--json"}) const {
        write("slide.toml", kSlide);
        write("two.toml", fmt::format("[[robot]]\nname = \"left\"\nmachine = \"slide.toml\"\n"
                                      "[[robot]]\nname = \"right\"\nmachine = \"slide.toml\"\n"
                                      "base = {{ x_mm = 700.0, y_mm = {}, roll_deg = 180.0 }}\n",
                                      y_mm));
        write("two.lua",
              "process('l', function() local _ENV = robot 'left' F(6000)\n"
              "  G1{x=600}\n"
              "end)\n"
              "process('r', function() local _ENV = robot 'right' F(3000)\n"
              "  wait(1)\n"
              "  G1{x=300}\n"
              "end)\n");
        std::vector<std::string> arguments{"--robots", "two.toml", "two.lua"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return gsim_run(arguments);
    }
};

// x = v (t - v / 2a) of each, from when it starts: the balls touch where both ways together are 700 - 40 mm.
TEST_F(TwoSlides, MeetAtTheSameTimeInBothPrograms) {
    const Ended e = meet(0);
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = json::parse(e.out)["robots"];
    const double t_s = (700 - 40 + 100 * 0.1 + 50 * (1 + 0.05)) / (100 + 50);
    const double left_mm = 100 * (t_s - 0.1) + 20;
    for (std::size_t i = 0; i < 2; ++i) {
        const json& collisions = robots[i]["collisions"];
        ASSERT_EQ(collisions.size(), 1U) << e.out;
        EXPECT_NEAR(collisions[0]["t_s"].get<double>(), t_s, 2e-8);
        EXPECT_EQ(collisions[0]["line"], i == 0 ? 2 : 6);
        EXPECT_EQ(collisions[0]["pair"], json::array({"ball", i == 0 ? "right: ball" : "left: ball"}));
        EXPECT_EQ(collisions[0]["kind"], "penetrating");
        // Each in its own world.
        EXPECT_NEAR(collisions[0]["point_mm"][0].get<double>(), i == 0 ? left_mm : 700 - left_mm, 1e-5);
        EXPECT_EQ(robots[i]["cell"]["looked_at"]["with_robots"], 1);
    }
    EXPECT_EQ(robots[0]["diagnostics"][1]["code"], "collision") << robots[0]["diagnostics"];
    EXPECT_EQ(meet(0, {"--no-collisions"}).status, 0);
}

TEST_F(TwoSlides, PassEachOtherAtADistance) {
    EXPECT_EQ(meet(40.001).status, 0);
    EXPECT_EQ(meet(39.999).status, 1);
}

TEST_F(TwoSlides, InTheSamePlaceAreNotLookedAt) {
    write("slide.toml", kSlide);
    write("same.toml",
          "[[robot]]\nname = \"left\"\nmachine = \"slide.toml\"\n"
          "[[robot]]\nname = \"right\"\nmachine = \"slide.toml\"\n");
    write("same.lua", "process('l', function() local _ENV = robot 'left' G0{x=100} end)\n");
    const Ended e = gsim_run({"--robots", "same.toml", "same.lua", "--json"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(json::parse(e.out)["warnings"],
              json::array({"robots 'left' and 'right' stand in the same place (base): not looked at against "
                           "each other; give each a base"}));
}

// A program that its own process runs far ahead is looked at all the same, and what it hits stands there.
TEST_F(TwoSlides, AreLookedAtHoweverFarOneRunsAhead) {
    meet(0);
    std::string program = "G21 G90 F6000\n";
    for (int pass = 0; pass < 20'000; ++pass) program += "G1 X1\nG1 X0\n";
    write("far.nc", program + "G0 X600\nM30\n");
    write("far.lua",
          "process('l', function() local _ENV = robot 'left' run 'far.nc' end)\n"
          "process('r', function() local _ENV = robot 'right' G0{x=200} wait(1) G0{x=100} end)\n");
    const Ended e = gsim_run({"--robots", "two.toml", "far.lua", "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = json::parse(e.out)["robots"];
    ASSERT_EQ(robots[0]["collisions"].size(), 1U);
    ASSERT_EQ(robots[1]["collisions"].size(), 1U);
    EXPECT_EQ(robots[0]["collisions"][0]["line"], 40'002);
    // It stands where its last move has ended, at 600 in the world of the left one.
    EXPECT_EQ(robots[1]["collisions"][0]["line"], 2);
    EXPECT_NEAR(robots[0]["collisions"][0]["point_mm"][0].get<double>(), 700 - 100 - 20, 1e-5);
}

// What a process has planned to its end is looked at, also where the other one's clock is ahead of it.
TEST_F(TwoSlides, AreLookedAtWhereAProcessHasEnded) {
    meet(0);
    write("ended.lua",
          "process('l', function() local _ENV = robot 'left' G0{x=200} wait(30) end)\n"
          "process('r', function() local _ENV = robot 'right' F(3000)\nG1{x=500}\nG1{x=0}\nend)\n");
    const Ended e = gsim_run({"--robots", "two.toml", "ended.lua", "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = json::parse(e.out)["robots"];
    for (std::size_t robot : {0, 1}) {
        ASSERT_EQ(robots[robot]["collisions"].size(), 1U) << e.out;
        EXPECT_NEAR(robots[robot]["collisions"][0]["t_s"].get<double>(), (700 - 200 - 40) / 50.0 + 0.05,
                    1e-7);
        EXPECT_EQ(robots[robot]["collisions"][0]["line"], robot == 0 ? 1 : 3);
    }
}

// The motion of a robot beside a conveyor is looked at only when what the conveyor does meanwhile is known.
TEST_F(TwoSlides, AreLookedAtBesideAConveyor) {
    write("slide.toml", kSlide);
    write("belt_cell.toml",
          "[cell]\nname = \"belt\"\n[[object]]\nname = \"blank\"\nshape = { sphere_mm = 10.0 }\n"
          "attached_to = \"belt\"\nframe = { z_mm = 900.0 }\n");
    write("belt.toml",
          "[[robot]]\nname = \"left\"\nmachine = \"slide.toml\"\ncell = \"belt_cell.toml\"\n"
          "[[robot]]\nname = \"right\"\nmachine = \"slide.toml\"\n"
          "base = { x_mm = 700.0, roll_deg = 180.0 }\n"
          "[[conveyor]]\nname = \"belt\"\ndirection = { y = 1.0 }\nspeed_mm_s = 1.0\n");
    write(
        "belt.lua",
        "process('l', function() local _ENV = robot 'left' F(3000) G1{x=600} end)\n"
        "process('r', function() local _ENV = robot 'right' G0{x=100} for i = 1, 20 do wait(0.7) end end)\n");
    const Ended e = gsim_run({"--robots", "belt.toml", "belt.lua", "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = json::parse(e.out)["robots"];
    for (std::size_t robot : {0, 1}) {
        ASSERT_EQ(robots[robot]["collisions"].size(), 1U) << e.out;
        EXPECT_NEAR(robots[robot]["collisions"][0]["t_s"].get<double>(), (600 - 40) / 50.0 + 0.05, 1e-7);
    }
}

/// Two slides that share the 100 mm in the middle between them.
class SharedZones : public TwoSlides {
  protected:
    json share(const std::string& left, const std::string& right, int status) const {
        write("slide.toml", kSlide);
        write("zones.toml",
              "[[robot]]\nname = \"left\"\nmachine = \"slide.toml\"\n"
              "[[robot]]\nname = \"right\"\nmachine = \"slide.toml\"\n"
              "base = { x_mm = 700.0, roll_deg = 180.0 }\n"
              "[[zone]]\nname = \"fixture\"\nshape = { box_mm = [100.0, 200.0, 200.0] }\n"
              "frame = { x_mm = 350.0 }\n"
              "[[zone]]\nname = \"table\"\nshape = { sphere_mm = 10.0 }\nframe = { x_mm = 350.0, z_mm = "
              "900.0 }\n");
        write("zones.lua", "process('l', function() local _ENV = robot 'left' F(6000)\n" + left +
                               "end)\nprocess('r', function() local _ENV = robot 'right' F(3000)\n" + right +
                               "end)\n");
        const Ended e = gsim_run({"--robots", "zones.toml", "zones.lua", "--json"});
        EXPECT_EQ(e.status, status) << e.err << e.out;
        return json::parse(e.out);
    }
};

// Rapids of 250 mm and feed moves of 100 mm, from rest to rest: d / v + v / a.
TEST_F(SharedZones, TheSecondWaitsUntilTheFirstHasLeft) {
    const std::string work =
        "G0{x=250}\nenter_zone 'fixture'\nF(6000) G1{x=350}\nG1{x=250}\nleave_zone 'fixture'\n";
    const json report = share(work, work, 0);
    const double there_s = 250 / 150.0 + 150 / 500.0;
    const double work_s = 2 * (100 / 100.0 + 100 / 500.0);
    const json& uses = report["zones"];
    ASSERT_EQ(uses.size(), 2U) << report;
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(uses[i]["zone"], "fixture");
        EXPECT_EQ(uses[i]["process"], i == 0 ? "l" : "r");
        EXPECT_EQ(uses[i]["line"], i == 0 ? 3 : 10);
        EXPECT_NEAR(uses[i]["asked_s"].get<double>(), there_s, 1e-9);
        EXPECT_NEAR(uses[i]["from_s"].get<double>(), there_s + static_cast<double>(i) * work_s, 1e-9);
        EXPECT_NEAR(uses[i]["to_s"].get<double>(), there_s + static_cast<double>(i + 1) * work_s, 1e-9);
        EXPECT_TRUE(report["robots"][i]["collisions"].empty());
    }
}

// The right one's ball is at the wall when it has gone 300 - 20 mm: x = v (t - v / 2a).
TEST_F(SharedZones, WhoEntersWhatAnotherHasIsTold) {
    const json report = share("enter_zone 'fixture'\nG0{x=1}\nwait(10)\n", "G1{x=300}\nG1{x=0}\n", 1);
    const json& right = report["robots"][1]["collisions"];
    ASSERT_EQ(right.size(), 1U) << report;
    EXPECT_NEAR(right[0]["t_s"].get<double>(), 280 / 50.0 + 0.05, 1e-7);
    EXPECT_EQ(right[0]["line"], 7);
    EXPECT_EQ(right[0]["pair"], json::array({"ball", "zone fixture of 'l'"}));
    const json& left = report["robots"][0]["collisions"];
    ASSERT_EQ(left.size(), 1U) << report;
    EXPECT_EQ(left[0]["t_s"], right[0]["t_s"]);
    EXPECT_EQ(left[0]["line"], 4);
    EXPECT_EQ(left[0]["pair"], json::array({"zone fixture", "right: ball"}));
    EXPECT_TRUE(report["zones"][0]["to_s"].is_null());
}

// One that is inside when another takes the zone is told from then on; one that nobody has may be entered.
TEST_F(SharedZones, WhoIsInsideWhenItIsTakenIsTold) {
    const json report = share("wait(7)\nenter_zone 'fixture'\n", "G1{x=300}\nwait(4)\nG1{x=0}\n", 1);
    ASSERT_EQ(report["robots"][1]["collisions"].size(), 1U) << report;
    EXPECT_NEAR(report["robots"][1]["collisions"][0]["t_s"].get<double>(), 7, 1e-9);
    EXPECT_EQ(report["robots"][1]["collisions"][0]["line"], 7);
}

// Whose robot it is counts, not what the process moves when it takes the zone.
TEST_F(SharedZones, AProcessMayBeInItsOwnWithEachOfItsRobots) {
    EXPECT_TRUE(share("G0{x=320}\nG0{x=0}\n", "", 0)["zones"].empty());
    write("before.lua",
          "process('a', function() enter_zone 'fixture' wait(1) local _ENV = robot 'left' G0{x=330} G0{x=0} "
          "end)\n");
    EXPECT_EQ(gsim_run({"--robots", "zones.toml", "before.lua", "--json"}).status, 0);
    write("both.lua",
          "process('a', function() local left, right = robot 'left', robot 'right' left.G0{x=1} enter_zone "
          "'fixture'\nleft.G0{x=330} right.G0{x=100} right.G0{x=1} left.G0{x=1} end)\n");
    EXPECT_EQ(gsim_run({"--robots", "zones.toml", "both.lua", "--json"}).status, 0);
}

// The holder has ended, and another process drives its robot in.
TEST_F(SharedZones, ARobotGoesWithTheProcessThatMovesIt) {
    share("", "", 0);
    write("after.lua",
          "process('a', function() local _ENV = robot 'left' G0{x=1} enter_zone 'fixture' end)\n"
          "process('c', function() wait(5) local _ENV = robot 'left' F(6000)\nG1{x=331} end)\n");
    const Ended e = gsim_run({"--robots", "zones.toml", "after.lua", "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json hits = json::parse(e.out)["robots"][0]["collisions"];
    ASSERT_EQ(hits.size(), 1U) << e.out;
    EXPECT_NEAR(hits[0]["t_s"].get<double>(), 5 + (300 - 20 - 1) / 100.0 + 0.1, 1e-7);
    EXPECT_EQ(hits[0]["pair"], json::array({"ball", "zone fixture of 'a'"}));
}

TEST_F(SharedZones, ADeadLockIsNamed) {
    const json report = share("enter_zone 'fixture'\nwait(1)\nenter_zone 'table'\n",
                              "enter_zone 'table'\nwait(2)\nenter_zone 'fixture'\n", 1);
    EXPECT_EQ(report["alarm"]["message"],
              "dead-lock: 'r' (zones.lua:9) waits for the zone 'fixture', which 'l' has, 'l' (zones.lua:4) "
              "waits for "
              "the zone 'table', which 'r' has");
    const json by_signal =
        share("enter_zone 'fixture'\nwait_until 'done'\n", "wait(1)\nenter_zone 'fixture'\n", 1);
    EXPECT_TRUE(holds(by_signal["alarm"]["message"],
                      "dead-lock, nothing can go on: 'l' (zones.lua:3) waits for 'done'"))
        << by_signal["alarm"];
    EXPECT_TRUE(holds(share("enter_zone 'fixtur'\n", "", 1)["alarm"]["message"], "did you mean 'fixture'?"));
    EXPECT_TRUE(
        holds(share("leave_zone 'table'\n", "", 1)["alarm"]["message"], "does not have the zone 'table'"));
}

// Rapids of 250 mm, feed moves of 100 mm, from rest to rest: d / v + v / a; and half a second at the fixture.
TEST_F(Robots, TheSampleOfTwoSlidesTakesTurns) {
    const Ended e = gsim_run({"--robots", kSample + "slides.toml", kSample + "slides.lua", "--json"});
    ASSERT_EQ(e.status, 0) << e.err;
    const json report = json::parse(e.out);
    const double rapid_s = 250 / 150.0 + 150 / 500.0;
    const double work_s = 2 * (100 / 100.0 + 100 / 500.0) + 0.5;
    // The right one waits while the left one works for the first time; later they are at it by turns.
    EXPECT_NEAR(report["robots"][0]["cycle_time_s"].get<double>(), 3 * (2 * rapid_s + work_s), 1e-9);
    EXPECT_NEAR(report["robots"][1]["idle_s"].get<double>(), work_s, 1e-9);
    EXPECT_TRUE(report["robots"][0]["collisions"].empty());
    EXPECT_EQ(report["robots"][1]["cell"]["looked_at"]["with_robots"], 1);
}

TEST_F(Robots, AnAlarmOfOneEndsTheRun) {
    const json report =
        run("process('l', function() local _ENV = robot 'left' wait(1)\nG1{x=9} end)\n"
            "process('r', function() local _ENV = robot 'right' for i = 1, 100 do wait(1) end end)\n");
    EXPECT_EQ(report["status"], "alarm");
    EXPECT_EQ(report["alarm"]["line"], 2);
    EXPECT_TRUE(report["robots"][1]["alarm"].is_null());
    EXPECT_TRUE(holds(run("robot 'lefd'\n")["alarm"]["message"], "did you mean 'left'?"));
    EXPECT_TRUE(holds(run("robot('left').run 'none.nc'\n")["alarm"]["message"], "no file 'none.nc'"));
    EXPECT_TRUE(holds(
        run("process('l', function() track 'belt' conveyor('belt').speed(3) end)\n")["alarm"]["message"],
        "cannot change"));
}

TEST_F(Robots, WhatDoesNotGoTogetherIsSaid) {
    const Ended e = run_sample({"--machine", "x.toml"});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(holds(e.err, "--machine does not go with --robots")) << e.err;
    write("bad.toml", "[[robot]]\nnam = 'x'\n");
    EXPECT_EQ(gsim_run({"--robots", "bad.toml", write("a.lua", "G0{x=1}")}).status, 2);
}

}  // namespace
}  // namespace gsim::apps::robots_test
