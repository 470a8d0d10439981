// Warnings about ramps that end short of their blocks.
#include "runtime/monitors/early_braking_monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::short_brakes_watch_test {
namespace {

using testing::HasSubstr;

motion::Segment crawl(double duration_s) {
    motion::Segment segment;
    segment.duration_s = duration_s;
    segment.limited_by = {motion::LimitKind::short_brakes, -1};
    return segment;
}

TEST(EarlyBrakingMonitor, IgnoresMovesWithoutEarlyBraking) {
    EarlyBrakingMonitor monitor;
    monitor.on_segment(arc(1, 0, 100, 100, 10, 0, 360), {.location = {0, 7}});
    EXPECT_FALSE(monitor.warning({"part.nc"}));
}

TEST(EarlyBrakingMonitor, ReportsTotalTimeAndWorstBlock) {
    EarlyBrakingMonitor monitor;
    monitor.on_segment(crawl(1.5), {.location = {0, 7}});
    monitor.on_segment(crawl(6), {.location = {0, 9}});
    const std::string said = monitor.warning({"part.nc"}).value_or("");
    EXPECT_THAT(said, HasSubstr("2 blocks"));
    EXPECT_THAT(said, HasSubstr("7.500 s in total"));
    EXPECT_THAT(said, HasSubstr("in 6.000 s in part.nc:9"));
}

}  // namespace
}  // namespace gsim::simulation::short_brakes_watch_test
