#include "collision/monitor/touch_search.h"

#include <cmath>

#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "tests/collision/segments.h"

namespace gsim::cell::touch_search_test {
namespace {

constexpr const char* kBall = "[[shape]]\nname = \"stylus\"\non = \"tool\"\nshape = { sphere_mm = 10 }\n";
constexpr const char* kBlock =
    "[[object]]\nname = \"block\"\nshape = { box_mm = [100, 100, 100] }\n"
    "frame = { x_mm = 550, y_mm = 500 }\n";  // its wall is at x = 500
constexpr double kSame_s = 3e-8;             // 1e-6 mm at 100 mm/s, and 1e-9 s

Cell cell_of(const std::string& tables) {
    auto cell = read_cell("[cell]\nname = \"test\"\n" + tables, "cell.toml", af5());
    EXPECT_TRUE(cell) << (cell ? "" : cell.error().message);
    return *std::move(cell);
}

TouchSearch make_search(const Cell& cell, const Eigen::Vector3d& tcp_mm = Eigen::Vector3d::Zero()) {
    return TouchSearch::make(cell, af5(), tcp_mm).value();
}

TEST(TouchSearch, FindsFirstTouchOfToolBody) {
    const Cell cell = cell_of(std::string(kBall) + kBlock);
    const TouchSearch search = make_search(cell);
    const motion::Segment path = line(0, joints(395, 500, 0), joints(520, 500, 0), {100});
    EXPECT_FALSE(search.touches(path.start));
    EXPECT_TRUE(search.touches(path.end));
    EXPECT_NEAR(search.first_touch_s(path).value(), 1, kSame_s);
    EXPECT_FALSE(search.first_touch_s(line(0, joints(395, 500, 0), joints(494.9, 500, 0), {100})));
}

TEST(TouchSearch, ReturnsEarliestOfSeveralTouches) {
    const Cell cell = cell_of(std::string(kBall) + kBlock +
                              "[[object]]\nname = \"post\"\nshape = { cylinder_mm = [20, 50] }\n"
                              "frame = { x_mm = 445, y_mm = 500 }\n");
    const motion::Segment path = line(0, joints(400, 500, 0), joints(520, 500, 0), {100});
    EXPECT_NEAR(make_search(cell).first_touch_s(path).value(), 0.3, kSame_s);
}

TEST(TouchSearch, UsesTcpIfToolHasNoBody) {
    const Cell cell = cell_of(kBlock);
    const motion::Segment path = line(0, joints(400, 500, 0), joints(520, 500, 0), {100});
    EXPECT_NEAR(make_search(cell).first_touch_s(path).value(), 1, kSame_s);
    EXPECT_NEAR(make_search(cell, {5, 0, 0}).first_touch_s(path).value(), 0.95, kSame_s);
    EXPECT_FALSE(make_search(cell, {0, 0, 60}).first_touch_s(path));  // it passes above
}

TEST(TouchSearch, FindsEndOfContact) {
    const Cell cell = cell_of(std::string(kBall) + kBlock);
    const TouchSearch search = make_search(cell);
    const motion::Segment away = line(0, joints(515, 500, 0), joints(395, 500, 0), {100});
    EXPECT_NEAR(search.first_release_s(away).value(), 0.2, kSame_s);
    EXPECT_FALSE(search.first_release_s(line(0, joints(515, 500, 0), joints(500, 500, 0), {100})));
}

// A ball 100 mm above the TCP leaves a wall as the tool turns back: 100 sin(angle) + 5 = 55.
TEST(TouchSearch, FindsTouchAndReleaseOfTurn) {
    const Cell cell = cell_of(
        "[[shape]]\nname = \"stylus\"\non = \"tool\"\nshape = { sphere_mm = 10 }\nframe = { z_mm = 100 }\n"
        "[[object]]\nname = \"wall\"\nshape = { box_mm = [10, 400, 400] }\nframe = { x_mm = 560, y_mm = 500 "
        "}\n");
    const TouchSearch search = make_search(cell);
    const motion::Segment there = line(0, joints(500, 500, 0), joints(500, 500, 0, 0, 0.6), {0.5});
    EXPECT_NEAR(search.first_touch_s(there).value(), std::asin(0.5) / 0.5, kSame_s);
    const motion::Segment back = line(0, joints(500, 500, 0, 0, 0.6), joints(500, 500, 0), {0.5});
    EXPECT_NEAR(search.first_release_s(back).value(), (0.6 - std::asin(0.5)) / 0.5, kSame_s);
}

TEST(TouchSearch, IgnoresJetAndNonToolBodies) {
    const Cell cell = cell_of(std::string(kBlock) +
                              "[[shape]]\nname = \"wrist\"\non = \"Z\"\nshape = { sphere_mm = 50 }\n"
                              "[[shape]]\nname = \"jet\"\non = \"jet\"\nshape = { sphere_mm = 50 }\n");
    const motion::Segment path = line(0, joints(400, 500, 0), joints(520, 500, 0), {100});
    EXPECT_NEAR(make_search(cell).first_touch_s(path).value(), 1, kSame_s);  // the TCP does
}

TEST(TouchSearch, RejectsCellWithMovableFrames) {
    Cell cell = cell_of(std::string(kBall) + kBlock);
    cell.make_movable(*cell.frames.find("block"), false);
    const auto search = TouchSearch::make(cell, af5(), {0, 0, 0});
    ASSERT_FALSE(search);
    EXPECT_EQ(search.error().message,
              "a probe cannot detect the bodies of a cell with frames that move independently (on conveyors, "
              "or moved by a program); on_probe of a script, or --probe, defines the contact");
}

}  // namespace
}  // namespace gsim::cell::touch_search_test
