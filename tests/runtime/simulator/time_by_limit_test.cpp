#include "runtime/report/time_by_limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::time_by_limit_test {
namespace {

using motion::LimitCause;
using motion::LimitKind;
using testing::ElementsAre;

class TimeByLimitTest : public testing::Test {
  protected:
    void add(LimitCause limited_by, double duration_s) {
        motion::Segment segment = line(1, 0, joints(0, 0), joints(100, 0));
        segment.limited_by = limited_by;
        segment.duration_s = duration_s;
        times.on_segment(segment, {});
    }
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const LimitTime& time : times.list(machine)) names.push_back(time.limited_by);
        return names;
    }

    machine::Machine machine = af5();
    TimeByLimit times;
};

TEST_F(TimeByLimitTest, SortsByTimeIncludingDwells) {
    add({LimitKind::feed, -1}, 2);
    add({LimitKind::joint_speed, 0}, 1);
    add({LimitKind::joint_speed, 3}, 5);
    add({LimitKind::feed, -1}, 2);
    times.on_segment(standstill(2, 0, joints(0, 0), 3), {.kind = MoveKind::dwell});
    const std::vector<LimitTime> list = times.list(machine);
    EXPECT_THAT(names(), ElementsAre("rotary B speed", "feed", "dwell", "joint X speed"));
    EXPECT_EQ(list[1].time_s, 4);
    EXPECT_EQ(list[2].time_s, 3);
}

TEST_F(TimeByLimitTest, MergesJointsWithSameLimitName) {
    add({LimitKind::jerk, 0}, 2);
    add({LimitKind::jerk, 1}, 1);
    EXPECT_THAT(names(), ElementsAre("jerk"));
    EXPECT_EQ(times.list(machine)[0].time_s, 3);
}

TEST_F(TimeByLimitTest, OmitsLimitsWithoutTime) {
    add({LimitKind::corner, -1}, 0);
    times.on_segment(standstill(2, 0, joints(0, 0), 0), {.kind = MoveKind::dwell});
    EXPECT_TRUE(times.list(machine).empty());
}

TEST_F(TimeByLimitTest, SumsOfManyTimesDoNotDrift) {
    constexpr int kCount = 200'000;
    for (int i = 0; i < kCount; ++i) add({LimitKind::feed, -1}, 0.1);
    EXPECT_DOUBLE_EQ(times.list(machine)[0].time_s, kCount * 0.1);
}

}  // namespace
}  // namespace gsim::simulation::time_by_limit_test
