#include "runtime/processes/robots_file.h"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

namespace gsim::process::robots_file_test {
namespace {

constexpr std::array<std::string_view, 2> kDialects{"ab9", "rs274ngc"};

constexpr const char* kGood = R"([[robot]]
name = "left"
[[robot]]
name = "right"
machine = "m.toml"
cell = "c.toml"
dialect = "rs274ngc"
base = { x_mm = 1000.0, roll_deg = 90.0 }
[[conveyor]]
name = "belt"
direction = { x = 3.0, y = 4.0 }
speed_mm_s = -20.0
[[zone]]
name = "fixture"
shape = { box_mm = [100.0, 200.0, 300.0] }
frame = { x_mm = 350.0 }
)";

TEST(RobotsFile, ReadsEntriesInOrder) {
    const auto file = read_robots(kGood, "cells/r.toml", kDialects);
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->robots.size(), 2U);
    EXPECT_EQ(file->robots[0].name, "left");
    EXPECT_TRUE(file->robots[0].machine.empty());
    EXPECT_EQ(file->robots[1].machine, "cells/m.toml");
    EXPECT_TRUE(file->robots[0].cell.empty());
    EXPECT_EQ(file->robots[1].cell, "cells/c.toml");
    EXPECT_EQ(file->robots[1].dialect, "rs274ngc");
    EXPECT_NEAR((file->robots[1].base * Eigen::Vector3d::UnitX() - Eigen::Vector3d(1000, 1, 0)).norm(), 0,
                1e-12);
    EXPECT_NEAR((file->conveyors.at(0).direction() - Eigen::Vector3d(0.6, 0.8, 0)).norm(), 0, 1e-15);
    EXPECT_EQ(file->conveyors.at(0).speed_mm_s(), -20);
    EXPECT_EQ(file->zones.at(0).name, "fixture");
    EXPECT_EQ(file->zones[0].form, machine::ShapeForm(machine::BoxShape{100, 200, 300}));
    EXPECT_EQ(file->zones[0].frame.translation().x(), 350);
}

void expect_error(const std::string& text, const std::string& part) {
    const auto file = read_robots(text, "r.toml", kDialects);
    ASSERT_FALSE(file) << text;
    EXPECT_NE(file.error().message.find(part), std::string::npos) << file.error().message;
    EXPECT_EQ(file.error().message.rfind("r.toml:", 0), 0U) << file.error().message;
}

TEST(RobotsFile, ReportsErrorsWithSourceLocation) {
    expect_error("", "lacks the key 'robot'");
    expect_error("robot = []", "at least one [[robot]]");
    expect_error("[[robot]]\nname = \"a b\"", "letters, digits");
    expect_error("[[robot]]\nname = \"a\"\n[[robot]]\nname = \"a\"",
                 "r.toml:4:8: the name 'a' is already used");
    expect_error("[[robot]]\nname = \"a\"\nmashine = \"x\"", "did you mean 'machine'?");
    expect_error("[[robot]]\nname = \"a\"\n[[conveyor]]\nname = \"b\"\ndirection = {}", "must not be zero");
    expect_error("[[robot]]\nname = \"a\"\n[[conveyor]]\nname = \"b\"\ndirection = { x = nan }",
                 "'x' must be");
    const std::string zone = "[[robot]]\nname = \"a\"\n[[zone]]\nname = \"z\"\n";
    expect_error(zone, "lacks the key 'shape'");
    expect_error(zone + "shape = { mesh = \"m.stl\" }", "r.toml:5:9: a zone must be a box");
    expect_error("[[robot", "");
}

}  // namespace
}  // namespace gsim::process::robots_file_test
