// Zones of programs and of machine data: the tool is monitored along its complete path, not at the ends of
// moves alone.

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_zones_test {
namespace {

const std::string kBox = "F(6000.0) G22{x=200, y=200, z=50, i=100, j=100, k=0} ";

void expect_enters(const std::string& lua, const std::vector<std::string>& texts) {
    std::vector<std::string> all{"enters the zone of G22"};
    all.insert(all.end(), texts.begin(), texts.end());
    expect_alarm(run_lua(kBox + "\n" + lua), 2, all);
}

TEST(Zones, RejectsMoveIntoZone) {
    expect_enters("G0{x=150, y=150}", {"axis X", "X100.0000 Y100.0000"});
    expect_enters("G1{y=150} G1{x=300}", {"axis X", "X100.0000 Y150.0000", "X 100 to 200"});
}

TEST(Zones, RejectsMoveThroughZoneWithBothEndsOutside) {
    expect_enters("G0{x=150} G0{x=0, y=300}", {"axis Y"});
    expect_enters("G1{x=300, y=300}", {"X100.0000 Y100.0000"});
    expect_enters("G1{z=51} G1{x=150} G1{y=150} G1{z=0}", {"axis Z", "Z50.0000"});
}

TEST(Zones, AcceptsMovePastWalls) {
    EXPECT_TRUE(run_lua(kBox + "G1{x=99} G1{x=99, y=300} G1{x=300, y=300} G1{x=300, y=0}").completed());
    EXPECT_TRUE(run_lua(kBox + "G1{z=50.1} G1{x=150, y=150} G1{z=60}").completed());
    EXPECT_TRUE(run_lua(kBox + "G1{y=200} G1{x=50, y=250} G1{x=150, y=200.1}").completed());
}

// The walls belong to the zone.
TEST(Zones, RejectsMoveAlongWall) {
    expect_enters("G1{x=100} G1{y=300}", {"axis Y", "X100.0000 Y100.0000"});
    expect_enters("G1{y=150} G1{x=100}", {"axis X", "X100.0000 Y150.0000"});
    expect_enters("G1{z=50} G1{x=150, y=150}", {"Z50.0000"});
}

TEST(Zones, ChecksArcAtDeepestPoint) {
    // Half circles about X150 Y0: radius 90 stays below the wall at Y100, radius 110 does not.
    EXPECT_TRUE(run_lua(kBox + "G1{x=60} G2{x=240, y=0, i=90}").completed());
    EXPECT_TRUE(run_lua(kBox + "G1{x=50.1} G2{x=249.9, y=0, i=99.9}").completed());
    expect_enters("G1{x=40} G2{x=260, y=0, i=110}",
                  {"axis Y", fmt::format("X{:.4f}", 150 - std::sqrt(2100.0))});
    // A helix that passes above the box.
    EXPECT_TRUE(run_lua(kBox + "G1{x=40, z=100} G2{x=260, y=0, z=90, i=110}").completed());
}

TEST(Zones, ToolInsideZoneMustStayInside) {
    const std::string inside = "F(6000.0) G0{x=150, y=150} G22{x=200, y=200, i=100, j=100}\n";
    EXPECT_TRUE(run_lua(inside + "G1{x=200, y=200, z=300} G1{x=100}").completed());
    expect_alarm(run_lua(inside + "G1{x=201}"), 2, {"leaves the zone", "axis X", "stay inside"});
    // Both ends of the arc are inside, its top is not.
    expect_alarm(run_lua(inside + "G1{x=100, y=160} G2{x=200, i=50}"), 2, {"leaves the zone"});
    expect_alarm(run_lua(inside + "G1{x=110, y=180} G2{x=190, i=40}"), 2, {"axis Y", "Y200.0000"});
}

TEST(Zones, G23DisablesAndG22EnablesZone) {
    EXPECT_TRUE(run_lua(kBox + "G23() G1{x=300, y=300}").completed());
    expect_alarm(run_lua(kBox + "G23() G1{x=0, y=300}\nG22()\nG1{x=300, y=0}"), 3, {"enters"});
    expect_alarm(run_lua("G22()"), 1, {"G22 needs its zone"});
    EXPECT_TRUE(run_lua("G23()").completed());
}

TEST(Zones, AcceptsCornersInAnyOrder) {
    expect_alarm(run_lua("G22{x=100, y=200, i=200, j=100}\nG0{x=150, y=150}"), 2, {"enters"});
    expect_alarm(run_lua("G20() G22{x=4, i=8}\nG0{x=5}"), 2, {"X 101.6 to 203.2"});
    expect_alarm(run_lua("G22{x=100}"), 1, {"both X and I"});
    expect_alarm(run_lua("G22{x=100, i=100}"), 1, {"no extent"});
    expect_alarm(run_lua("G22{x=100, i=200, p=1}"), 1,
                 {"[word-out-of-place]", "G22", "not accept the word P"});
}

TEST(Zones, AreInMachineCoordinates) {
    expect_alarm(run_lua(kBox + "G52{x=1000}\nG0{y=150}\nG0{x=-850}"), 3, {"X100.0000"});
}

// Against a fine walk along each straight move.
TEST(Zones, AgreeWithSamplingOfRandomMoves) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> location(0, 300);
    for (int n = 0; n < 150; ++n) {
        const double a[3] = {location(random), location(random), location(random)};
        const double b[3] = {location(random), location(random), location(random)};
        double depth = -1e9;  // depth of the path in the box
        for (int i = 0; i <= 3000; ++i) {
            const double t = i / 3000.0;
            double current = 1e9;
            for (int k = 0; k < 3; ++k) {
                const double at = a[k] + t * (b[k] - a[k]);
                current = std::min({current, at - 100, 200 - at});
            }
            depth = std::max(depth, current);
        }
        if (std::abs(depth) < 0.1) continue;
        bool starts_inside = true;
        for (const double value : a) starts_inside = starts_inside && value > 100 && value < 200;
        if (starts_inside) continue;
        const std::string lua = fmt::format(
            "G0{{x={}, y={}, z={}}} G22{{x=200, y=200, z=200, i=100, j=100, k=100}} G0{{x={}, y={}, z={}}}",
            a[0], a[1], a[2], b[0], b[1], b[2]);
        EXPECT_EQ(run_lua(lua).completed(), depth < 0) << lua;
    }
}

// --- Zones of the machine data ---

Conditions with_zones() {
    Conditions setup = with_tools();
    machine::Zone zone;
    zone.number = 4;
    zone.limits[0] = {100, 200};
    zone.limits[1] = {100, 200};
    zone.active_at_start = false;
    zone.switch_number = 3;
    setup.options.data.security_zones[4] = zone;
    zone = {.number = 1, .kind = machine::ZoneKind::working};
    zone.limits[0] = {-1, 600};
    setup.options.data.working_zone = zone;
    return setup;
}

TEST(Zones, MachineDataZonesApplyFromStart) {
    expect_alarm(run("G0 X500\nG1 X700 F6000", with_zones()), 2,
                 {"leaves the working zone on axis X", "X600.0000"});
    Conditions ngc = with_zones();
    ngc.options.dialect = "rs274ngc";
    expect_alarm(run("G21\nG0 X500\nG1 X700 F6000\nM2", ngc), 3, {"leaves the working zone on axis X"});
}

TEST(Zones, MachineDataZonesSwitchByNumber) {
    EXPECT_TRUE(run("G0 X150 Y150\nG0 X0 Y0", with_zones()).completed());
    const Outcome on = run("G22 P3\nG1 X150 F6000\nY150", with_zones());
    EXPECT_NE(on.lua.find("G22{p=3}"), std::string::npos) << on.lua;
    expect_alarm(on, 3, {"enters security zone 4 on axis Y", "X150.0000 Y100.0000"});
    EXPECT_TRUE(run("G22 P3\nG0 X150\nG23 P3\nG0 Y150\n", with_zones()).completed());
    expect_alarm(run("G22 P9", with_zones()), 1, {"no zone has SWITCH=9"});
    expect_alarm(run_lua("G23{p=1.5}", with_zones()), 1, {"from 1 to 99"});
    Conditions ngc = with_zones();
    ngc.options.dialect = "rs274ngc";
    expect_alarm(run_lua("require 'gsim.rs274ngc'\nG21()\nswitch_zone(3, true)\nG0{x=150, y=150}", ngc), 4,
                 {"enters security zone 4"});
}

TEST(Zones, MachineDataAndProgramZonesApplyTogether) {
    const std::string both = "G22 P3\nG22 X300 I400\nG0 X50\n";
    expect_alarm(run(both + "G0 Y250\nX350", with_zones()), 5, {"enters the zone of G22"});
    expect_alarm(run(both + "G0 Y150\nX350", with_zones()), 5, {"enters security zone 4"});
    EXPECT_TRUE(run(both + "G23\nG0 Y250\nX350", with_zones()).completed());
}

// The offset of the move gives the position of the tool's end, not that of the block that is read.
TEST(Zones, ApplyToTcp) {
    const std::string low = "G0 Z100\nG22 Z50 K0\n";
    expect_alarm(run(low + "G1 Z49 F6000", with_tools()), 3, {"axis Z", "Z50.0000"});
    const Outcome shifted = run(low + "G43 H2\nG1 Z51 F6000\nG1 Z49\nG49", with_tools());
    expect_alarm(shifted, 5, {"Z50.0000"});
    EXPECT_NEAR(shifted.end()[2], 75, 1e-9);
}

// The corner of a box on a diagonal: from first principles, to a microsecond.
TEST(Zones, EntryTimeFollowsTimeLaw) {
    for (const double x : {20.0, 100.0, 200.0, 280.0}) {
        SCOPED_TRACE(x);
        const Outcome ended =
            run(fmt::format("F6000 G22 X{} Y{} I400 J400\nG1 X300 Y300", x, x), with_tools());
        expect_alarm(ended, 2, {"enters the zone of G22"});
        const double distance = std::sqrt(2.0) * x;
        const double left = std::sqrt(2.0) * (300 - x);
        const double ramp_mm = 100 * 100 / kAcceleration_mm_s2 / 2;
        const double total_s = trapezoid_s(std::sqrt(2.0) * 300, 100, kAcceleration_mm_s2);
        double wanted_s = 100 / kAcceleration_mm_s2 / 2 + distance / 100;
        if (distance < ramp_mm) wanted_s = std::sqrt(2 * distance / kAcceleration_mm_s2);
        if (left < ramp_mm) wanted_s = total_s - std::sqrt(2 * left / kAcceleration_mm_s2);
        EXPECT_NEAR(ended.report.cycle_time_s, wanted_s, 1e-9);
        EXPECT_NEAR(ended.end()[0], x, 1e-6);
        EXPECT_NEAR(ended.end()[1], x, 1e-6);
    }
}

TEST(Zones, ReportExcludesMotionAfterAlarm) {
    const Outcome ended = run("F6000 G22 X100 I200\nG1 X50\nM8\nX150\nM9\nX300", with_tools());
    expect_alarm(ended, 4, {"X100.0000"});
    EXPECT_EQ(ended.events(), "jet_on");
    EXPECT_NEAR(ended.report.distances.feed_mm, 100, 1e-6);
}

TEST(Zones, CheckArcsThroughPointAndCompensatedMoves) {
    expect_alarm(run_lua("F(6000.0) G22{x=40, i=60, y=20, j=90}\nCIP{x=100, i1=50, j1=50}"), 2, {"enters"});
    // The path is 3 mm off the programmed one, which keeps out of the zone.
    expect_alarm(
        run("F6000 G22 X-10 I500 Y52 J60\nG0 X20 Y20\nG41 D1 G1 Y50\nX200\nY20\nG40 X0", with_tools()), 3,
        {"axis Y", "Y52.0000"});
}

}  // namespace
}  // namespace gsim::script::ab9_zones_test
