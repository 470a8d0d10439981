// gsim-run --robots: zones in which one robot may be at a time.

#include "base/text/json.h"
#include "tests/apps/robots/two_slides.h"

namespace gsim::apps::shared_zones_test {
namespace {

using nlohmann::json;

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
        return text::parse_json<json>(e.out);
    }
};

// Rapids of 250 mm and feed moves of 100 mm, from standstill to standstill: d / v + v / a.
TEST_F(SharedZones, SecondRobotWaitsUntilFirstLeaves) {
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
        EXPECT_NEAR(uses[i]["requested_s"].get<double>(), there_s, 1e-9);
        EXPECT_NEAR(uses[i]["from_s"].get<double>(), there_s + static_cast<double>(i) * work_s, 1e-9);
        EXPECT_NEAR(uses[i]["to_s"].get<double>(), there_s + static_cast<double>(i + 1) * work_s, 1e-9);
        EXPECT_TRUE(report["robots"][i]["collisions"].empty());
    }
}

// The right one's ball is at the wall when it has gone 300 - 20 mm: x = v (t - v / 2a).
TEST_F(SharedZones, ReportEntryIntoOccupiedZone) {
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

// A robot that is inside when another takes the zone is reported from then on; a zone without a holder may be
// entered.
TEST_F(SharedZones, ReportRobotInsideZoneWhenOccupied) {
    const json report = share("wait(7)\nenter_zone 'fixture'\n", "G1{x=300}\nwait(4)\nG1{x=0}\n", 1);
    ASSERT_EQ(report["robots"][1]["collisions"].size(), 1U) << report;
    EXPECT_NEAR(report["robots"][1]["collisions"][0]["t_s"].get<double>(), 7, 1e-9);
    EXPECT_EQ(report["robots"][1]["collisions"][0]["line"], 7);
}

// The owner of the robot counts, not what the process moves when it takes the zone.
TEST_F(SharedZones, ProcessEntersItsZoneWithAnyOfItsRobots) {
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
TEST_F(SharedZones, RobotBelongsToProcessMovingIt) {
    share("", "", 0);
    write("after.lua",
          "process('a', function() local _ENV = robot 'left' G0{x=1} enter_zone 'fixture' end)\n"
          "process('c', function() wait(5) local _ENV = robot 'left' F(6000)\nG1{x=331} end)\n");
    const Ended e = gsim_run({"--robots", "zones.toml", "after.lua", "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json hits = text::parse_json<json>(e.out)["robots"][0]["collisions"];
    ASSERT_EQ(hits.size(), 1U) << e.out;
    EXPECT_NEAR(hits[0]["t_s"].get<double>(), 5 + (300 - 20 - 1) / 100.0 + 0.1, 1e-7);
    EXPECT_EQ(hits[0]["pair"], json::array({"ball", "zone fixture of 'a'"}));
}

TEST_F(SharedZones, ReportDeadlock) {
    const json report = share("enter_zone 'fixture'\nwait(1)\nenter_zone 'table'\n",
                              "enter_zone 'table'\nwait(2)\nenter_zone 'fixture'\n", 1);
    EXPECT_EQ(report["alarm"]["message"],
              "deadlock: 'r' (zones.lua:9) waits for the zone 'fixture', which 'l' occupies, 'l' "
              "(zones.lua:4) waits for the zone 'table', which 'r' occupies");
    const json by_signal =
        share("enter_zone 'fixture'\nwait_until 'done'\n", "wait(1)\nenter_zone 'fixture'\n", 1);
    EXPECT_TRUE(contains(by_signal["alarm"]["message"],
                         "deadlock, no process can continue: 'l' (zones.lua:3) waits for 'done'"))
        << by_signal["alarm"];
    EXPECT_TRUE(
        contains(share("enter_zone 'fixtur'\n", "", 1)["alarm"]["message"], "did you mean 'fixture'?"));
    EXPECT_TRUE(contains(share("leave_zone 'table'\n", "", 1)["alarm"]["message"],
                         "does not occupy the zone 'table'"));
}

// A device that runs endlessly does not hide the dead-lock; without one, no process can continue.
TEST_F(SharedZones, ZoneOccupiedAfterEndCausesDeadlock) {
    share("", "", 0);
    const std::string device = "device('belt', function() while true do wait(0.5) end end)\n";
    const std::string left = "process('l', function() enter_zone 'fixture' wait(3) end)\n";
    for (const char* const wait : {"1", "4"}) {
        write("kept.lua",
              device + left + "process('r', function() wait(" + wait + ")\nenter_zone 'fixture' end)\n");
        const Ended e = gsim_run({"--robots", "zones.toml", "kept.lua", "--json"});
        EXPECT_EQ(e.status, 1) << e.err;
        EXPECT_EQ(text::parse_json<json>(e.out)["robots"][0]["alarm"]["message"],
                  "deadlock: 'r' (kept.lua:4) waits for the zone 'fixture', which 'l' occupies, although "
                  "it has ended")
            << e.out;
    }
}

}  // namespace
}  // namespace gsim::apps::shared_zones_test
