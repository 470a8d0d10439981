// Holders of zones, those that wait for one, and whom each waits for.

#include "runtime/processes/shared_zones.h"

#include <gtest/gtest.h>

namespace gsim::process::shared_zones_test {
namespace {

std::vector<SharedZone> named(std::initializer_list<const char*> names) {
    std::vector<SharedZone> zones;
    for (const char* name : names) zones.push_back({name, machine::SphereShape{1}, rrs::CartPos::Identity()});
    return zones;
}

TEST(SharedZones, OneHoldsZoneAndOthersWaitInOrder) {
    Schedule schedule;
    SharedZones zones(named({"fixture"}));
    const ProcessId a = schedule.add("a", false, 0, {});
    const ProcessId b = schedule.add("b", false, 1, {});
    const ProcessId c = schedule.add("c", false, 0.5, {});
    EXPECT_TRUE(zones.enter(schedule, 0, a));
    EXPECT_FALSE(zones.enter(schedule, 0, c));
    EXPECT_FALSE(zones.enter(schedule, 0, b));
    EXPECT_EQ(schedule.process(b).state, ProcessState::waiting);
    schedule.process(a).time_s = 3;
    EXPECT_EQ(zones.leave(schedule, 0), c);
    EXPECT_EQ(zones.holder(0), c);
    EXPECT_EQ(schedule.process(c).state, ProcessState::ready);
    EXPECT_EQ(schedule.process(c).time_s, 3);
    EXPECT_EQ(schedule.waits({}), "'b' waits for the zone 'fixture', which 'c' occupies");
    schedule.process(c).time_s = 5;
    EXPECT_EQ(zones.leave(schedule, 0), b);
    EXPECT_EQ(zones.leave(schedule, 0), std::nullopt);
    ASSERT_EQ(zones.uses().size(), 3U);
    EXPECT_EQ(zones.uses()[1].process, "c");
    EXPECT_EQ(zones.uses()[1].requested_s, 0.5);
    EXPECT_EQ(zones.uses()[1].from_s, 3);
    EXPECT_EQ(zones.uses()[1].to_s, 5);
}

TEST(SharedZones, FindsCycleOfWaiters) {
    Schedule schedule;
    SharedZones zones(named({"x", "y", "z"}));
    std::vector<ProcessId> ids;
    for (const char* name : {"a", "b", "c"}) ids.push_back(schedule.add(name, false, 0, {}));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(zones.enter(schedule, i, ids[i]));
    EXPECT_FALSE(zones.enter(schedule, 1, ids[0]));
    EXPECT_TRUE(schedule.deadlocked_from(ids[0]).empty());
    EXPECT_FALSE(zones.enter(schedule, 2, ids[1]));
    EXPECT_FALSE(zones.enter(schedule, 0, ids[2]));
    const std::vector<ProcessId> ring = schedule.deadlocked_from(ids[2]);
    EXPECT_EQ(schedule.waits({}, ring),
              "'c' waits for the zone 'x', which 'a' occupies, 'a' waits for the zone 'y', which 'b' "
              "occupies, 'b' waits for the zone 'z', which 'c' occupies");
}

TEST(SharedZones, FinishedHolderCausesDeadlock) {
    Schedule schedule;
    SharedZones zones(named({"fixture", "table"}));
    std::vector<ProcessId> ids;
    for (const char* const name : {"a", "b", "c"}) ids.push_back(schedule.add(name, false, 0, {}));
    zones.enter(schedule, 0, ids[0]);
    zones.enter(schedule, 1, ids[1]);
    zones.enter(schedule, 0, ids[1]);
    EXPECT_TRUE(schedule.deadlocked_from(ids[1]).empty()) << "a may still let it go";
    EXPECT_EQ(schedule.find_zone_waiter(ids[0]), ids[1]);
    EXPECT_EQ(schedule.find_zone_waiter(ids[1]), std::nullopt);
    schedule.finish(ids[0]);
    EXPECT_EQ(schedule.deadlocked_from(ids[1]), std::vector<ProcessId>{ids[1]});
    zones.enter(schedule, 1, ids[2]);
    EXPECT_EQ(schedule.deadlocked_from(ids[2]), (std::vector<ProcessId>{ids[2], ids[1]})) << "through b";
}

}  // namespace
}  // namespace gsim::process::shared_zones_test
