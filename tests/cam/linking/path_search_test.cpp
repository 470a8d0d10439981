#include "cam/linking/path_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::linking::way_search_test {
namespace {

constexpr int kQuestions = 4000;

AxisValues at(std::initializer_list<double> values) {
    AxisValues position(static_cast<Eigen::Index>(values.size()));
    std::copy(values.begin(), values.end(), position.data());
    return position;
}

/// Box that no path may enter; its last axes may be left out.
struct Box {
    std::vector<double> low, high;
};

// By the slabs of the box.
bool enters(const AxisValues& from, const AxisValues& to, const Box& box) {
    double first = 0;
    double last = 1;
    for (std::size_t i = 0; i < box.low.size(); ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        const double displacement = to[axis] - from[axis];
        if (displacement == 0) {
            if (from[axis] <= box.low[i] || from[axis] >= box.high[i]) return false;
            continue;
        }
        const double a = (box.low[i] - from[axis]) / displacement;
        const double b = (box.high[i] - from[axis]) / displacement;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first < last;
}

struct Room {
    SearchSpace space;
    std::vector<Box> boxes;
    int questions = 0;

    Room(AxisValues low, AxisValues high, std::vector<Box> walls) : boxes(std::move(walls)) {
        space.low = low;
        space.high = high;
        space.s_per_unit = AxisValues::Ones(low.size());
        space.is_clear = [this](const AxisValues& from, const AxisValues& to) {
            ++questions;
            return is_clear(from, to);
        };
        space.seconds = [](const AxisValues& from, const AxisValues& to) { return (to - from).norm(); };
    }
    bool is_clear(const AxisValues& from, const AxisValues& to) const {
        return std::none_of(boxes.begin(), boxes.end(),
                            [&](const Box& box) { return enters(from, to, box); });
    }
    void expect_way(const AxisValues& from, const AxisValues& to, double max) {
        const auto displacement = search_path(space, from, to, kQuestions);
        ASSERT_TRUE(displacement);
        const AxisValues* last = &from;
        for (const AxisValues& node : *displacement) {
            EXPECT_TRUE(is_clear(*last, node));
            EXPECT_TRUE((node.array() >= space.low.array()).all() &&
                        (node.array() <= space.high.array()).all());
            last = &node;
        }
        EXPECT_EQ(*last, to);
        EXPECT_LE(path_duration_s(space, from, *displacement), max);
    }
};

TEST(PathSearch, FindsStraightPathWithoutObstacles) {
    Room room(at({0, 0}), at({100, 100}), {});
    EXPECT_EQ(search_path(room.space, at({10, 10}), at({90, 90}), kQuestions), (AxisPath{at({90, 90})}));
}

// The path passes one edge of a wall; the shortest path is two straight lines over it.
TEST(PathSearch, FindsPathAroundWall) {
    Room room(at({0, 0}), at({100, 100}), {{{45, -1}, {55, 60}}});
    const double shortest = 2 * std::hypot(35, 50) + 10;
    room.expect_way(at({10, 10}), at({90, 10}), 1.15 * shortest);
}

TEST(PathSearch, FindsDoorInThreeDimensions) {
    // A wall across the space with a door of 12 by 12.
    const std::vector<Box> walls{{{48, -1, -1}, {52, 70, 101}},
                                 {{48, 82, -1}, {52, 101, 101}},
                                 {{48, -1, -1}, {52, 101, 20}},
                                 {{48, -1, 32}, {52, 101, 101}}};
    Room room(at({0, 0, 0}), at({100, 100, 100}), walls);
    const double by_middle =
        (at({50, 76, 26}) - at({10, 10, 90})).norm() + (at({50, 76, 26}) - at({90, 10, 90})).norm();
    room.expect_way(at({10, 10, 90}), at({90, 10, 90}), 1.1 * by_middle);
}

// The path is clear only if the last axis is turned, and that axis must turn back after it.
TEST(PathSearch, RotatesAxisToPassObstacle) {
    std::vector<Box> walls{{{40, -1, -101}, {60, 101, 40}}};  // passable with the third axis above 40
    Room room(at({0, 0, -100}), at({100, 100, 100}), walls);
    room.expect_way(at({10, 50, 0}), at({90, 50, 0}), 1.2 * (2 * std::hypot(30, 40) + 20));
}

TEST(PathSearch, ReturnsNothingIfNoPathExists) {
    Room room(at({0, 0}), at({100, 100}), {{{45, -1}, {55, 101}}});
    EXPECT_FALSE(search_path(room.space, at({10, 10}), at({90, 10}), kQuestions));
    EXPECT_LE(room.questions, 3 * kQuestions + 10);
}

TEST(PathSearch, IsDeterministic) {
    Room room(at({0, 0}), at({100, 100}), {{{45, -1}, {55, 60}}, {{20, 30}, {40, 101}}});
    const auto first = search_path(room.space, at({10, 10}), at({90, 10}), kQuestions);
    const auto second = search_path(room.space, at({10, 10}), at({90, 10}), kQuestions);
    ASSERT_TRUE(first);
    EXPECT_EQ(*first, *second);
}

TEST(PathSearch, ShortcutIsFasterAndStaysClear) {
    Room room(at({0, 0}), at({100, 100}), {{{45, -1}, {55, 60}}});
    const AxisPath round{at({10, 95}), at({50, 95}), at({70, 99}), at({90, 70}), at({90, 10})};
    const AxisPath less = shortcut(room.space, at({10, 10}), round);
    EXPECT_LT(path_duration_s(room.space, at({10, 10}), less),
              path_duration_s(room.space, at({10, 10}), round));
    const AxisValues from = at({10, 10});
    const AxisValues* last = &from;
    for (const AxisValues& node : less) {
        EXPECT_TRUE(room.is_clear(*last, node));
        last = &node;
    }
    EXPECT_EQ(less.back(), round.back());
}

}  // namespace
}  // namespace gsim::linking::way_search_test
