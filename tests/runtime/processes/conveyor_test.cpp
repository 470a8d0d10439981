#include "runtime/processes/conveyor.h"

#include <cmath>

#include <gtest/gtest.h>

namespace gsim::process::conveyor_test {
namespace {

TEST(Conveyor, TravelIsSumOfSpeedTimesTime) {
    Conveyor belt("belt", Eigen::Vector3d::UnitX(), 10);
    EXPECT_DOUBLE_EQ(belt.position_mm(2), 20);
    belt.set_speed(-5, 2);
    EXPECT_DOUBLE_EQ(belt.position_mm(4), 10);
    belt.set_speed(0, 4);
    EXPECT_DOUBLE_EQ(belt.position_mm(100), 10);
}

TEST(Conveyor, ReturnsArrivalTime) {
    Conveyor belt("belt", Eigen::Vector3d::UnitX(), 10);
    EXPECT_DOUBLE_EQ(belt.arrival_time_s(50, 1), 5);
    EXPECT_DOUBLE_EQ(belt.arrival_time_s(5, 1), 1);  // it is past it
    belt.set_speed(0, 1);
    EXPECT_DOUBLE_EQ(belt.arrival_time_s(10, 1), 1);
    EXPECT_TRUE(std::isinf(belt.arrival_time_s(50, 1)));
}

}  // namespace
}  // namespace gsim::process::conveyor_test
