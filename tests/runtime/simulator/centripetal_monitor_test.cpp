// Arcs that need more than the axes of their plane have, and only those.
#include "runtime/monitors/centripetal_monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::centripetal_watch_test {
namespace {

using testing::HasSubstr;

constexpr double kRadius_mm = 10;
constexpr double kAsked_mm_s2 = kSpeed_mm_s * kSpeed_mm_s / kRadius_mm;  // 250

/// Returns the warning about a full circle in XY at kSpeed_mm_s, if the linear axes have these accelerations.
std::optional<std::string> said_of_circle(double x, double y, double z,
                                          std::optional<double> y_deceleration = {}) {
    machine::Machine machine = af5();
    machine.axes[0].max_acceleration = x;
    machine.axes[1].max_acceleration = y;
    machine.axes[1].max_deceleration = y_deceleration;
    machine.axes[2].max_acceleration = z;
    CentripetalMonitor monitor(machine);
    monitor.on_segment(arc(1, 0, 100, 100, kRadius_mm, 0, 360), {.location = {0, 7}});
    return monitor.warning({"part.nc"});
}

TEST(CentripetalMonitor, AcceptsArcAtAxisLimitAndWarnsAbove) {
    EXPECT_FALSE(said_of_circle(kAsked_mm_s2, kAsked_mm_s2, kAsked_mm_s2));
    EXPECT_THAT(said_of_circle(240, 300, 300).value_or(""), HasSubstr("250 mm/s2 of 240 in part.nc:7"));
    EXPECT_THAT(said_of_circle(300, 240, 300).value_or(""), HasSubstr("250 mm/s2 of 240"));
}

TEST(CentripetalMonitor, IgnoresAxesAcrossPlane) {
    EXPECT_FALSE(said_of_circle(300, 300, 1));
}

TEST(CentripetalMonitor, WarnsIfDecelerationIsTooSmall) {
    EXPECT_THAT(said_of_circle(300, 300, 300, 200).value_or(""), HasSubstr("250 mm/s2 of 200"));
}

TEST(CentripetalMonitor, InclinedAxisCountsByItsShare) {
    machine::Machine machine = af5();
    for (machine::Axis& axis : machine.axes) axis.max_acceleration = 1e6;
    machine.axes[2].max_acceleration = 200;  // of 250 sin(30 deg) = 125
    motion::Segment tilted = arc(1, 0, 100, 100, kRadius_mm, 0, 360);
    tilted.arc.v = {0, std::cos(std::numbers::pi / 6), std::sin(std::numbers::pi / 6)};
    CentripetalMonitor monitor(machine);
    monitor.on_segment(tilted, {});
    EXPECT_FALSE(monitor.warning({}));
}

}  // namespace
}  // namespace gsim::simulation::centripetal_watch_test
