// gsim-run --robots: one robot against another.

#include "base/text/json.h"
#include "tests/apps/robots/two_slides.h"

namespace gsim::apps::robots_meet_test {
namespace {

using nlohmann::json;

// x = v (t - v / 2a) of each, from its start: the balls touch if both distances together are 700 - 40 mm.
TEST_F(TwoSlides, CollideAtSameTimeInBothPrograms) {
    const Ended e = meet(0);
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = text::parse_json<json>(e.out)["robots"];
    const double t_s = (700 - 40 + 100 * 0.1 + 50 * (1 + 0.05)) / (100 + 50);
    const double left_mm = 100 * (t_s - 0.1) + 20;
    for (std::size_t i = 0; i < 2; ++i) {
        const json& collisions = robots[i]["collisions"];
        ASSERT_EQ(collisions.size(), 1U) << e.out;
        EXPECT_NEAR(collisions[0]["t_s"].get<double>(), t_s, 2e-8);
        EXPECT_EQ(collisions[0]["line"], i == 0 ? 2 : 6);
        EXPECT_EQ(collisions[0]["pair"], json::array({"ball", i == 0 ? "right: ball" : "left: ball"}));
        EXPECT_EQ(collisions[0]["kind"], "penetrating");
        // Each point is in its own world.
        EXPECT_NEAR(collisions[0]["point_mm"][0].get<double>(), i == 0 ? left_mm : 700 - left_mm, 1e-5);
        EXPECT_EQ(robots[i]["cell"]["checked"]["with_robots"], 1);
    }
    EXPECT_EQ(robots[0]["diagnostics"][1]["code"], "collision") << robots[0]["diagnostics"];
    EXPECT_EQ(meet(0, {"--no-collisions"}).status, 0);
}

TEST_F(TwoSlides, PassEachOtherAtDistance) {
    EXPECT_EQ(meet(40.001).status, 0);
    EXPECT_EQ(meet(39.999).status, 1);
}

TEST_F(TwoSlides, AreNotCheckedAtSameBasePosition) {
    write("slide.toml", kSlide);
    write("same.toml",
          "[[robot]]\nname = \"left\"\nmachine = \"slide.toml\"\n"
          "[[robot]]\nname = \"right\"\nmachine = \"slide.toml\"\n");
    write("same.lua", "process('l', function() local _ENV = robot 'left' G0{x=100} end)\n");
    const Ended e = gsim_run({"--robots", "same.toml", "same.lua", "--json"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(text::parse_json<json>(e.out)["warnings"],
              json::array({"robots 'left' and 'right' have the same base position: not checked against each "
                           "other; give each a base"}));
}

// A program that its own process runs far ahead is checked all the same, and a body that it hits is at
// standstill there.
TEST_F(TwoSlides, AreCheckedIfOneRunsFarAhead) {
    meet(0);
    std::string program = "G21 G90 F6000\n";
    for (int pass = 0; pass < 20'000; ++pass) program += "G1 X1\nG1 X0\n";
    write("far.nc", program + "G0 X600\nM30\n");
    write("far.lua",
          "process('l', function() local _ENV = robot 'left' run 'far.nc' end)\n"
          "process('r', function() local _ENV = robot 'right' G0{x=200} wait(1) G0{x=100} end)\n");
    const Ended e = gsim_run({"--robots", "two.toml", "far.lua", "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = text::parse_json<json>(e.out)["robots"];
    ASSERT_EQ(robots[0]["collisions"].size(), 1U);
    ASSERT_EQ(robots[1]["collisions"].size(), 1U);
    EXPECT_EQ(robots[0]["collisions"][0]["line"], 40'002);
    // The robot stays at the end of its last move, at 600 in the world of the left one.
    EXPECT_EQ(robots[1]["collisions"][0]["line"], 2);
    EXPECT_NEAR(robots[0]["collisions"][0]["point_mm"][0].get<double>(), 700 - 100 - 20, 1e-5);
}

// The motion that a process has planned to its end is checked, even if the other one's clock is ahead of it.
TEST_F(TwoSlides, AreCheckedAfterProcessEnds) {
    meet(0);
    write("ended.lua",
          "process('l', function() local _ENV = robot 'left' G0{x=200} wait(30) end)\n"
          "process('r', function() local _ENV = robot 'right' F(3000)\nG1{x=500}\nG1{x=0}\nend)\n");
    const Ended e = gsim_run({"--robots", "two.toml", "ended.lua", "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const json robots = text::parse_json<json>(e.out)["robots"];
    for (std::size_t robot : {0, 1}) {
        ASSERT_EQ(robots[robot]["collisions"].size(), 1U) << e.out;
        EXPECT_NEAR(robots[robot]["collisions"][0]["t_s"].get<double>(), (700 - 200 - 40) / 50.0 + 0.05,
                    1e-7);
        EXPECT_EQ(robots[robot]["collisions"][0]["line"], robot == 0 ? 1 : 3);
    }
}

// The motion of a robot next to a conveyor is checked only after the simultaneous motion of the conveyor is
// known.
TEST_F(TwoSlides, AreCheckedNextToConveyor) {
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
    const json robots = text::parse_json<json>(e.out)["robots"];
    for (std::size_t robot : {0, 1}) {
        ASSERT_EQ(robots[robot]["collisions"].size(), 1U) << e.out;
        EXPECT_NEAR(robots[robot]["collisions"][0]["t_s"].get<double>(), (600 - 40) / 50.0 + 0.05, 1e-7);
    }
}

}  // namespace
}  // namespace gsim::apps::robots_meet_test
