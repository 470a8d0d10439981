// Path at another position, in another order, at other feeds.
#include "toolpath/placement/changes.h"

#include <Eigen/Geometry>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include <gmock/gmock.h>

#include "machine/file/machine_file.h"
#include "motion/kinematics/pose.h"
#include "tests/build_files/build_files.h"
#include "tests/toolpath/random_path.h"
#include "toolpath/json/json_reader.h"
#include "toolpath/model/arc_shape.h"

namespace gsim::path::changes_test {
namespace {

using testing::HasSubstr;

machine::Machine read_sample(const std::string& name) {
    std::ifstream file(tests::source_path("samples/machines/") + name);
    std::stringstream text;
    text << file.rdbuf();
    return machine::read_machine(text.str(), name).value();
}

Program wheel() {
    std::ifstream file(tests::source_path("samples/wheel.path.json"));
    std::stringstream text;
    text << file.rdbuf();
    return read_json(text.str(), "wheel").value().program;
}

rrs::CartPos motion_of(double x_mm, double y_mm, double z_mm, double roll_rad, double pitch_rad = 0,
                       double yaw_rad = 0) {
    return kinematics::pose_from_rpy({x_mm, y_mm, z_mm, roll_rad, pitch_rad, yaw_rad});
}

/// Returns the tool's direction with the rotary axes at the values of a point, or as the point gives it.
Eigen::Vector3d axis_at(const MachineSpace& space, const Point& point) {
    if (const auto* axis = std::get_if<ToolAxis>(&*point.orientation))
        return to_eigen(axis->direction).normalized();
    AxisValues rotary = space.home_rotary();
    for (std::size_t i = 0; i < space.rotary_count(); ++i)
        rotary[static_cast<Eigen::Index>(i)] =
            std::get<RotaryAxes>(*point.orientation).at(space.rotary_axis(i).letter);
    return space.tool_axis(space.axes(to_eigen(point.position_mm), rotary));
}

/// Halfway between two points, as rotary axes in proportion turn it.
Eigen::Vector3d axis_between(const MachineSpace& space, Point first, const Point& second) {
    for (auto& [letter, value] : std::get<RotaryAxes>(*first.orientation))
        value = (value + std::get<RotaryAxes>(*second.orientation).at(letter)) / 2;
    return axis_at(space, first);
}

void expect_moved(const Program& before, const Program& behind, const rrs::CartPos& motion,
                  const MachineSpace& space, bool with_between) {
    for (std::size_t p = 0; p < before.paths.size(); ++p) {
        const Point* last[2] = {nullptr, nullptr};
        for (std::size_t i = 0; i < before.paths[p].targets.size(); ++i) {
            const auto* one = std::get_if<Point>(&before.paths[p].targets[i]);
            if (one == nullptr) continue;
            const auto& other = std::get<Point>(behind.paths[p].targets[i]);
            EXPECT_LT((motion * to_eigen(one->position_mm) - to_eigen(other.position_mm)).norm(), 1e-9);
            if (!one->orientation) continue;
            EXPECT_LT((motion.linear() * axis_at(space, *one) - axis_at(space, other)).norm(), 1e-9);
            if (with_between && last[0] != nullptr) {
                const Eigen::Vector3d between = motion.linear() * axis_between(space, *last[0], *one);
                EXPECT_LT((between - axis_between(space, *last[1], other)).norm(), 1e-9)
                    << "the wall between two points has another shape";
            }
            last[0] = one;
            last[1] = &other;
        }
    }
}

TEST(PathChanges, RotationAboutVerticalKeepsShape) {
    const machine::Machine gantry = read_sample("af5.toml");
    const MachineSpace space = MachineSpace::make(gantry).value();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi), coordinate(-300, 300);
    for (int i = 0; i < 20; ++i) {
        const rrs::CartPos motion =
            motion_of(coordinate(random), coordinate(random), coordinate(random), angle(random));
        Program placed = wheel();
        const auto done = place(placed, motion, space);
        ASSERT_TRUE(done) << done.error().message;
        expect_moved(wheel(), placed, motion, space, true);
    }
}

TEST(PathChanges, ArbitraryRotationMovesPositionsAndToolAxes) {
    const machine::Machine gantry = read_sample("af5.toml");
    const MachineSpace space = MachineSpace::make(gantry).value();
    const rrs::CartPos motion = motion_of(10, 20, 30, 0.3, 0.2, -0.1);
    Program placed = wheel();
    ASSERT_TRUE(place(placed, motion, space));
    expect_moved(wheel(), placed, motion, space, false);
}

// The axis of a table that turns the work turns in the other direction.
TEST(PathChanges, RotationWithRotaryTableKeepsRotaryAxes) {
    const machine::Machine mill = read_sample("mill-table-table.toml");
    const MachineSpace space = MachineSpace::make(mill).value();
    ASSERT_EQ(space.rotary_count(), 2U);
    Point point;
    point.position_mm = {10, 20, 30};
    RotaryAxes rotary;
    for (std::size_t i = 0; i < 2; ++i)
        rotary[space.rotary_axis(i).letter] = 20 + 15 * static_cast<double>(i);
    point.orientation = rotary;
    const Program before{"p", {{"p", {point}}}, 0};
    for (const double turn_rad : {0.4, -2.0}) {
        Program placed = before;
        ASSERT_TRUE(place(placed, motion_of(5, 0, 0, turn_rad), space));
        expect_moved(before, placed, motion_of(5, 0, 0, turn_rad), space, false);
        EXPECT_TRUE(
            std::holds_alternative<RotaryAxes>(*std::get<Point>(placed.paths[0].targets[0]).orientation));
    }
}

TEST(PathChanges, ArcsKeepRadiusAndAngle) {
    const machine::Machine gantry = read_sample("af5.toml");
    const MachineSpace space = MachineSpace::make(gantry).value();
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const Program before = random_program(random);
        Program placed = before;
        const rrs::CartPos motion = motion_of(100, -50, 20, 0.1 * i);
        if (const auto done = place(placed, motion, space); !done) {
            EXPECT_THAT(done.error().message, HasSubstr("must define the positions of the rotary axes"));
            continue;
        }
        for (std::size_t p = 0; p < before.paths.size(); ++p) {
            for (std::size_t t = 1; t < before.paths[p].targets.size(); ++t) {
                const auto* from = std::get_if<Point>(&before.paths[p].targets[t - 1]);
                const auto* to = std::get_if<Point>(&before.paths[p].targets[t]);
                if (from == nullptr || to == nullptr || to->motion != MotionType::circular) continue;
                const ArcShape one = arc_shape(from->position_mm, *to).value();
                const ArcShape other = arc_shape(std::get<Point>(placed.paths[p].targets[t - 1]).position_mm,
                                                 std::get<Point>(placed.paths[p].targets[t]))
                                           .value();
                EXPECT_NEAR(one.radius_mm(), other.radius_mm(), 1e-6);
                EXPECT_NEAR(one.turn_rad, other.turn_rad, 1e-6);
                EXPECT_LT((motion * one.at(0.5) - other.at(0.5)).norm(), 1e-5);
            }
        }
    }
}

TEST(PathChanges, RejectsUnplaceablePaths) {
    const machine::Machine gantry = read_sample("af5.toml");
    const MachineSpace space = MachineSpace::make(gantry).value();
    const auto error = [&](Program program) {
        return place(program, motion_of(1, 0, 0, 1), space).error().message;
    };
    Program recorded = wheel();
    recorded.work_offsets["54"] = {};
    EXPECT_THAT(error(recorded), HasSubstr("recorded"));
    Program framed = wheel();
    framed.paths[1].frame.name = "55";
    EXPECT_THAT(error(framed), HasSubstr("several work frames"));
    Program bare = wheel();
    std::get<Point>(bare.paths[1].targets[0]).orientation = RotaryAxes{{'C', 0}};
    EXPECT_THAT(error(bare), HasSubstr("positions of the rotary axes B"));
}

// The tool of a machine without rotary axes keeps its direction.
TEST(PathChanges, RejectsTiltWithoutRotaryAxes) {
    const machine::Machine router = read_sample("router3.toml");
    const MachineSpace space = MachineSpace::make(router).value();
    Point point;
    point.position_mm = {10, 20, 30};
    Program program{"p", {{"p", {point}}}, 0};
    EXPECT_THAT(place(program, motion_of(0, 0, 0, 0, 0.2), space).error().message,
                HasSubstr("would be tilted"));
    ASSERT_TRUE(place(program, motion_of(0, 0, 0, 1.5), space));
    EXPECT_NEAR(std::get<Point>(program.paths[0].targets[0]).position_mm[2], 30, 1e-12);
}

// The axis positions at a reference point are not turned along with the path.
TEST(PathChanges, NeedsAllRotaryAxesAfterMachinePoint) {
    const machine::Machine mill = read_sample("mill-table-table.toml");
    const MachineSpace space = MachineSpace::make(mill).value();
    Point full, part;
    full.orientation = RotaryAxes{{'A', -30}, {'C', 20}};
    part.orientation = RotaryAxes{{'A', -10}};
    const MachinePoint home{.kind = MachinePoint::Kind::reference, .number = 1, .axes = {{'A', 0}, {'C', 0}}};
    const auto placed = [&](std::vector<Target> targets) {
        Program program{"p", {{"p", std::move(targets)}}, 0};
        return place(program, motion_of(0, 0, 0, 0.7), space);
    };
    EXPECT_TRUE(placed({full, part}));
    EXPECT_THAT(placed({full, home, part}).error().message, HasSubstr("positions of the rotary axes C"));
    EXPECT_TRUE(placed({full, home, full}));
}

Point point_at(double x_mm, std::optional<double> feed_mm_min, bool turned = true) {
    Point point;
    point.position_mm = {x_mm, 0, 0};
    if (turned) point.orientation = ToolAxis{};
    point.feed_mm_min = feed_mm_min;
    return point;
}

tl::expected<void, TargetError> put_in_order(Program& program, const std::vector<std::size_t>& order) {
    static const machine::Machine gantry = read_sample("af5.toml");
    return reorder(program, order, MachineSpace::make(gantry).value());
}

Program of_three(Path third) {
    return {"p",
            {{"root", {SubPath{1}, SubPath{2}, SubPath{3}}},
             {"a", {point_at(1, 100)}},
             {"b", {point_at(2, 200)}},
             std::move(third)},
            0};
}

TEST(PathChanges, ReordersSubPaths) {
    Program program = of_three({"c", {point_at(3, 300)}});
    ASSERT_TRUE(put_in_order(program, {2, 0, 1}));
    const auto& targets = program.paths[0].targets;
    EXPECT_EQ(std::get<SubPath>(targets[0]).path, 3U);
    EXPECT_EQ(std::get<SubPath>(targets[1]).path, 1U);
    EXPECT_EQ(std::get<SubPath>(targets[2]).path, 2U);
}

// A value that a sub-path takes over from the one before would differ in another order.
TEST(PathChanges, RejectsReorderingIfStateIsInherited) {
    const std::vector<std::size_t> order{2, 0, 1};
    const auto error = [&](Path third) {
        Program program = of_three(std::move(third));
        return put_in_order(program, order).error().message;
    };
    EXPECT_THAT(error({"c", {point_at(3, std::nullopt)}}),
                HasSubstr("'c' needs a separate feed before it cuts"));
    EXPECT_THAT(error({"c", {point_at(3, 300, false)}}),
                HasSubstr("the first point of the sub-path 'c' needs an orientation with all rotary axes"));
    Point arc = point_at(3, 300);
    arc.motion = MotionType::circular;
    EXPECT_THAT(error({"c", {arc}}), HasSubstr("straight motion"));
    Point on = point_at(3, 300);
    on.actions = {"waterjet_on"};
    EXPECT_THAT(error({"c", {on}}), HasSubstr("'a' would begin with a different active state"));
    Program program = of_three({"c", {point_at(3, 300)}});
    EXPECT_THAT(put_in_order(program, {0, 0, 1}).error().message, HasSubstr("each of 0 to 2 once"));
    // Half of an orientation is taken over, too; values that are not compared may continue.
    Point half = point_at(3, 300);
    half.orientation = RotaryAxes{{'C', 0}};
    EXPECT_THAT(error({"c", {half}}), HasSubstr("all rotary axes"));
    for (const char* action : {"path_mode exact_path", "digital_output P3 on", "ramps linear"}) {
        Point mode = point_at(3, 300);
        mode.actions = {action};
        EXPECT_THAT(error({"c", {mode}}),
                    HasSubstr(std::string("'") + action + "' may remain active, so that the order matters"))
            << action;
    }
    Point turning = point_at(3, 300);
    turning.feed_deg_min = 100;
    EXPECT_THAT(error({"c", {turning}}), HasSubstr("feed of rotary axes remains active"));
    Point reported = point_at(3, 300);
    reported.actions = {"message done", "waterjet_on", "waterjet_off"};
    Program fine = of_three({"c", {reported}});
    EXPECT_TRUE(put_in_order(fine, order));
}

TEST(PathChanges, AcceptsAnyOrderOfWheel) {
    std::vector<std::size_t> order{0, 1, 2};
    do {
        Program program = wheel();
        const auto done = put_in_order(program, order);
        EXPECT_TRUE(done) << done.error().message;
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(PathChanges, SetsOrScalesFeeds) {
    Program program = of_three({"c", {point_at(3, 300), point_at(4, std::nullopt)}});
    ASSERT_TRUE(change_feeds(program, {.value = 0.5}));
    EXPECT_EQ(std::get<Point>(program.paths[1].targets[0]).feed_mm_min, 50);
    EXPECT_EQ(std::get<Point>(program.paths[3].targets[0]).feed_mm_min, 150);
    EXPECT_FALSE(std::get<Point>(program.paths[3].targets[1]).feed_mm_min);
    ASSERT_TRUE(change_feeds(program, {.path = "b", .value = 77, .is_factor = false}));
    EXPECT_EQ(std::get<Point>(program.paths[2].targets[0]).feed_mm_min, 77);
    EXPECT_EQ(std::get<Point>(program.paths[1].targets[0]).feed_mm_min, 50);
    Program turned = of_three({"c", {point_at(3, 300)}});
    std::get<Point>(turned.paths[3].targets[0]).feed_mm_rev = 0.1;
    ASSERT_TRUE(change_feeds(turned, {.path = "c", .value = 3000, .is_factor = false}));
    EXPECT_NEAR(*std::get<Point>(turned.paths[3].targets[0]).feed_mm_rev, 1.0, 1e-12) << "at the same turns";
    EXPECT_THAT(change_feeds(program, {.path = "bb", .value = 1}).error().message,
                HasSubstr("did you mean 'b'?"));
    EXPECT_THAT(change_feeds(program, {.path = "root", .value = 1}).error().message,
                HasSubstr("no point of 'root'"));
}

TEST(PathChanges, RejectsChangeOfInheritedFeed) {
    const FeedChange change{.path = "b", .value = 2};
    Program accepts = of_three({"c", {point_at(3, std::nullopt)}});
    EXPECT_THAT(change_feeds(accepts, change).error().message,
                HasSubstr("'c' inherits a feed and needs a separate one"));
    EXPECT_EQ(std::get<Point>(accepts.paths[2].targets[0]).feed_mm_min, 200) << "nothing is done by halves";
    ASSERT_TRUE(change_feeds(accepts, {.path = "a", .value = 2})) << "b has its own, and hands that over";
    // After a sub-path, in the path that uses it.
    Program behind = of_three({"c", {point_at(3, 300)}});
    behind.paths[0].targets = {SubPath{2}, point_at(9, std::nullopt)};
    EXPECT_THAT(change_feeds(behind, change).error().message,
                HasSubstr("'root' inherits a feed and needs a separate one"));
    // The second time round.
    Program repeated = of_three({"c", {point_at(3, std::nullopt), SubPath{2}}});
    repeated.paths[0].targets = {SubPath{1}, SubPath{3, 2}};
    EXPECT_THAT(change_feeds(repeated, change).error().message,
                HasSubstr("'c' inherits a feed and needs a separate one"));
    repeated.paths[0].targets = {SubPath{1}, SubPath{3, 1}};
    EXPECT_TRUE(change_feeds(repeated, change));
}

}  // namespace
}  // namespace gsim::path::changes_test
