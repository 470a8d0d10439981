#include "tests/accuracy/trajectory.h"

#include <sstream>

#include <gtest/gtest.h>

namespace gsim::accuracy::trajectory_test {
namespace {

using Position = std::array<double, 3>;

Trajectory read(const std::string& text) {
    std::istringstream csv(text);
    auto trajectory = read_trajectory(csv);
    EXPECT_TRUE(trajectory) << trajectory.error().message;
    return std::move(trajectory).value_or(Trajectory{});
}

std::string error(const std::string& text) {
    std::istringstream csv(text);
    const auto trajectory = read_trajectory(csv);
    return trajectory ? "none" : trajectory.error().message;
}

TEST(Trajectory, IsReadByColumnNames) {
    const Trajectory recorded = read(
        "t,x,y,z,b,c,current_vel,line,motion_type\n"
        "0.000,0.0,0.0,0.0,0.0,0.0,1.0,0,0\n"
        "0.010,0.04,-1.5,2.25,7,8,11.0,3,2\n");
    ASSERT_EQ(recorded.size(), 2U);
    EXPECT_EQ(recorded[1].t_s, 0.01);
    EXPECT_EQ(recorded[1].at_mm, (Position{0.04, -1.5, 2.25}));
    const Trajectory found = read("t_s,line,z_mm,x_mm,y_mm,speed_mm_s\r\n0,,3,1,2,0\r\n");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].at_mm, (Position{1, 2, 3}));
}

TEST(Trajectory, ReportsUnreadableInput) {
    EXPECT_EQ(error(""), "the trajectory lacks a column for time, X, Y or Z");
    EXPECT_EQ(error("t,x,y\n0,0,0\n"), "the trajectory lacks a column for time, X, Y or Z");
    EXPECT_EQ(error("t,x,y,z\n"), "the trajectory is empty");
    EXPECT_EQ(error("t,x,y,z\n0,0,0,0\n0.1,0,0\n"), "line 3 of the trajectory cannot be understood");
    EXPECT_EQ(error("t,x,y,z\n0,0,nan,0\n"), "line 2 of the trajectory cannot be understood");
    EXPECT_EQ(error("t,x,y,z\n0,0,1mm,0\n"), "line 2 of the trajectory cannot be understood");
    EXPECT_EQ(error("t,x,y,z\n1,0,0,0\n0.5,0,0,0\n"), "line 3 of the trajectory cannot be understood");
}

TEST(Trajectory, IsLinearBetweenSamplesAndConstantOutside) {
    const Trajectory trajectory{{1, {0, 0, 0}}, {2, {10, -4, 0}}, {2, {20, 0, 0}}, {4, {20, 0, 8}}};
    EXPECT_EQ(place_at_mm(trajectory, 0), (Position{0, 0, 0}));
    EXPECT_EQ(place_at_mm(trajectory, 1.25), (Position{2.5, -1, 0}));
    EXPECT_EQ(place_at_mm(trajectory, 2), (Position{10, -4, 0}));
    EXPECT_EQ(place_at_mm(trajectory, 3.5), (Position{20, 0, 6}));
    EXPECT_EQ(place_at_mm(trajectory, 4), (Position{20, 0, 8}));
    EXPECT_EQ(place_at_mm(trajectory, 99), (Position{20, 0, 8}));
}

}  // namespace
}  // namespace gsim::accuracy::trajectory_test
