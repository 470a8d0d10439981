// Next process to run, and what each process waits for.

#include "runtime/processes/schedule.h"

#include <gtest/gtest.h>

namespace gsim::process::schedule_test {
namespace {

TEST(Schedule, ActivatesEarliestAndFirstOfEqualTimes) {
    Schedule schedule;
    const ProcessId a = schedule.add("a", false, 2, {});
    const ProcessId b = schedule.add("b", false, 1, {});
    const ProcessId c = schedule.add("c", false, 1, {});
    EXPECT_EQ(schedule.activate_next(), b);
    schedule.finish(b);
    EXPECT_EQ(schedule.activate_next(), c);
    EXPECT_TRUE(schedule.continues(c));
    schedule.process(c).time_s = 2;
    EXPECT_FALSE(schedule.continues(c));
    EXPECT_EQ(schedule.activate_next(), a);
}

TEST(Schedule, SignalChangeWakesMatchingWaitersAtItsTime) {
    Schedule schedule;
    const ProcessId on = schedule.add("on", false, 0, {});
    const ProcessId five = schedule.add("five", false, 0, {});
    const ProcessId falls = schedule.add("falls", false, 0, {});
    schedule.wait(on, {.kind = WaitKind::on, .signal = "s"});
    schedule.wait(five, {.kind = WaitKind::equals, .signal = "s", .value = 5.0});
    schedule.wait(falls, {.kind = WaitKind::falls, .signal = "s"});
    EXPECT_FALSE(schedule.activate_next());
    EXPECT_TRUE(schedule.has_unfinished());
    schedule.changed("other", false, true, 1);
    EXPECT_FALSE(schedule.activate_next());
    schedule.changed("s", false, 5.0, 3);
    EXPECT_EQ(schedule.process(on).state, ProcessState::ready);
    EXPECT_EQ(schedule.process(five).state, ProcessState::ready);
    EXPECT_DOUBLE_EQ(schedule.process(five).time_s, 3);
    EXPECT_EQ(schedule.process(falls).state, ProcessState::waiting);
    schedule.changed("s", 5.0, 0.0, 4);
    EXPECT_DOUBLE_EQ(schedule.process(falls).time_s, 4);
    EXPECT_DOUBLE_EQ(schedule.process(on).time_s, 3);
}

TEST(Schedule, WaitEndsAtTimeout) {
    Schedule schedule;
    const ProcessId a = schedule.add("a", false, 0, {});
    schedule.wait(a, {.kind = WaitKind::on, .signal = "s", .until_s = 2.5});
    ASSERT_EQ(schedule.activate_next(), a);
    EXPECT_TRUE(schedule.process(a).timed_out);
    EXPECT_DOUBLE_EQ(schedule.process(a).time_s, 2.5);
}

TEST(Schedule, DevicesDoNotKeepRunActive) {
    Schedule schedule;
    schedule.add("device", true, 0, {});
    EXPECT_FALSE(schedule.has_unfinished());
    EXPECT_FALSE(schedule.activate_next());
}

TEST(Schedule, DescribesWaitsWithLocationAndCondition) {
    Schedule schedule;
    const ProcessId a = schedule.add("a", false, 0, {0, 12});
    const ProcessId b = schedule.add("b", true, 0, {});
    schedule.wait(a, {.kind = WaitKind::equals, .signal = "level", .value = 2.5});
    schedule.wait(b, {});
    EXPECT_EQ(schedule.waits({"cell.lua"}),
              "'a' (cell.lua:12) waits for 'level' to be 2.5, 'b' waits for a user-defined condition");
}

TEST(Signals, NumberOneEqualsSwitchOn) {
    SignalBoard board;
    EXPECT_FALSE(is_on(board.get("s")));
    EXPECT_TRUE(board.set("s", true));
    EXPECT_FALSE(board.set("s", 1.0));
    EXPECT_TRUE(board.set("s", 2.0));
    EXPECT_EQ(value_text(board.get("s")), "2");
}

}  // namespace
}  // namespace gsim::process::schedule_test
