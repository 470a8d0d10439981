#include "runtime/report/limit_name.h"

#include <gtest/gtest.h>

#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::limit_name_test {
namespace {

using motion::LimitKind;

TEST(LimitName, NamesLinearAndRotaryAxesByLetter) {
    const machine::Machine machine = af5();
    EXPECT_EQ(describe({LimitKind::joint_speed, 0}, machine), "joint X speed");
    EXPECT_EQ(describe({LimitKind::joint_speed, 3}, machine), "rotary B speed");
    EXPECT_EQ(describe({LimitKind::acceleration, 2}, machine), "joint Z acceleration");
    EXPECT_EQ(describe({LimitKind::acceleration, 4}, machine), "rotary C acceleration");
}

TEST(LimitName, NamesLimitsOfPath) {
    const machine::Machine machine = af5();
    EXPECT_EQ(describe({LimitKind::feed, -1}, machine), "feed");
    EXPECT_EQ(describe({LimitKind::path_speed, -1}, machine), "contour speed");
    EXPECT_EQ(describe({LimitKind::path_acceleration, -1}, machine), "path acceleration");
    EXPECT_EQ(describe({LimitKind::centripetal, -1}, machine), "centripetal");
    EXPECT_EQ(describe({LimitKind::corner, -1}, machine), "corner");
    EXPECT_EQ(describe({LimitKind::stop, -1}, machine), "stop");
    EXPECT_EQ(describe({LimitKind::jerk, 1}, machine), "jerk");
    EXPECT_EQ(describe({LimitKind::look_ahead, -1}, machine), "look-ahead");
    EXPECT_EQ(describe({LimitKind::time, -1}, machine), "time");
}

TEST(LimitName, OmitsLetterOfUnknownJoint) {
    const machine::Machine machine = af5();
    EXPECT_EQ(describe({LimitKind::joint_speed, -1}, machine), "joint speed");
    EXPECT_EQ(describe({LimitKind::acceleration, 100}, machine), "joint acceleration");
}

}  // namespace
}  // namespace gsim::simulation::limit_name_test
