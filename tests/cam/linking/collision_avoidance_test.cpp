#include "cam/linking/collision_avoidance.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "collision/monitor/clearance_monitor.h"
#include "machine/file/machine_file.h"
#include "runtime/simulator/make_planner_setup.h"
#include "toolpath/model/validate.h"

namespace gsim::linking::clear_ways_test {
namespace {

using path::MotionType;
using path::Point;

/// The machine that is built in, without its bodies: cells here give it a pin as its tool.
machine::Machine pin_machine(bool interpolated = true) {
    machine::Machine machine = machine::read_machine(machine::built_in_machine_toml(), "af5.toml").value();
    machine.shapes.clear();
    machine.ignored.clear();
    machine.controller.coordination.interpolated_rapids = interpolated;
    return machine;
}

cell::Cell cell_of(const machine::Machine& machine, const std::string& objects) {
    const std::string text =
        "[cell]\nname = \"test\"\nclearance_mm = 3\n"
        "[[shape]]\nname = \"pin\"\non = \"tool\"\nshape = { cylinder_mm = [10, 60] }\nframe = { z_mm = 30 "
        "}\n"
        "[[shape]]\nname = \"jet\"\non = \"jet\"\nshape = { cylinder_mm = [1, 40] }\nframe = { z_mm = -20 "
        "}\n" +
        objects;
    auto cell = cell::read_cell(text, "cell.toml", machine);
    EXPECT_TRUE(cell) << (cell ? "" : cell.error().message);
    return *std::move(cell);
}

std::string box(const std::string& name, const std::string& size, double x, double y, double z,
                const std::string& more = "") {
    return fmt::format(
        "[[object]]\nname = \"{}\"\nshape = {{ box_mm = [{}] }}\nframe = {{ x_mm = {}, y_mm = {}, z_mm = {} "
        "}}\n{}",
        name, size, x, y, z, more);
}

Point rapid(double x, double y, double z, std::vector<std::string> actions = {}) {
    Point point;
    point.motion = MotionType::rapid;
    point.position_mm = {x, y, z};
    point.actions = std::move(actions);
    return point;
}

Point line(double x, double y, double z, std::vector<std::string> actions = {}) {
    Point point = rapid(x, y, z, std::move(actions));
    point.motion = MotionType::linear;
    point.feed_mm_min = 600;
    return point;
}

const path::ToolAxis kVerticalAxis{{0, 0, 1}};

// Returns cuts of 20 mm along x from some positions, each a path, with rapids 25 mm above between them.
path::Program cuts_at(const std::vector<path::Vector>& places, const path::ToolAxis& axis = kVerticalAxis) {
    path::Program program;
    program.name = "cuts";
    program.paths.resize(1);
    program.paths[0].name = "all";
    for (const auto& [x, y, z] : places) {
        program.paths[0].targets.emplace_back(path::SubPath{program.paths.size(), 1});
        path::Path& path = program.paths.emplace_back();
        path.name = fmt::format("contour {}", program.paths.size() - 1);
        Point above = rapid(x, y, z + 25);
        above.orientation = axis;
        path.targets = {above, rapid(x, y, z, {"waterjet_on"}), line(x + 20, y, z, {"waterjet_off"}),
                        rapid(x + 20, y, z + 25)};
    }
    EXPECT_FALSE(path::validate(program));
    return program;
}

class CollisionAvoidance : public ::testing::Test {
  protected:
    LinkingResult lead(path::Program& program, const std::string& objects, Origin origin = {}) {
        cell_ = cell_of(machine_, objects);
        space_ = path::MachineSpace::make(machine_).value();
        const motion::PlannerSetup setup = simulation::make_planner_setup(machine_);
        const auto bodies = cell::CollisionChecker::make(*cell_, machine_).value();
        const RapidPlanner space(*space_, setup, bodies, origin, has_orientations(program));
        auto linking = avoid_collisions(program, space, start());
        EXPECT_TRUE(linking) << (linking ? "" : linking.error().message);
        EXPECT_FALSE(path::validate(program));
        look(program, space, origin);
        return linking ? *linking : LinkingResult{};
    }

    AxisValues start() const { return space_->home(); }

    // Checks once more, by the monitor of runs alone.
    void look(const path::Program& program, const RapidPlanner& space, const Origin& origin) {
        cell::ClearanceMonitor monitor(*cell_, machine_);
        const auto steps = axis_steps(program, *space_, origin).value();
        AxisValues at = start();
        least_mm_ = cell_->clearance_mm;
        cuts_.clear();
        for (const AxisStep& step : steps) {
            monitor.begin_block();
            monitor.on_segment(space.rapid(at, step.axes), step.process_on);
            if (monitor.nearest() && step.rapid)
                least_mm_ = std::min(least_mm_, monitor.nearest()->distance_mm);
            if (!step.rapid) cuts_.push_back(step.axes);
            at = step.axes;
        }
        contacts_ = monitor.contacts().size();
    }

    machine::Machine machine_ = pin_machine();
    std::optional<cell::Cell> cell_;
    std::optional<path::MachineSpace> space_;
    std::size_t contacts_ = 0;
    double least_mm_ = 0;           ///< In rapids, or the clearance.
    std::vector<AxisValues> cuts_;  ///< Their end positions.
};

const std::vector<path::Vector> kTwo{{300, 300, 100}, {500, 300, 100}};

TEST_F(CollisionAvoidance, KeepsProgramWithoutObstacles) {
    path::Program program = cuts_at(kTwo);
    const path::Program before = program;
    const LinkingResult linking = lead(program, box("far", "50, 50, 50", 900, 900, 25));
    EXPECT_EQ(program, before);
    EXPECT_EQ(linking.linking_paths, 3U);
    EXPECT_EQ(linking.changed, 0U);
    EXPECT_TRUE(linking.errors.empty());
}

TEST_F(CollisionAvoidance, ReroutesRapidAroundClampBetweenCuts) {
    path::Program program = cuts_at(kTwo);
    const LinkingResult linking = lead(program, box("clamp", "20, 100, 160", 410, 300, 80));  // up to 160
    EXPECT_EQ(linking.changed, 1U);
    EXPECT_TRUE(linking.errors.empty());
    EXPECT_EQ(contacts_, 0U);
    EXPECT_GE(least_mm_, 3 - 1e-6);
    ASSERT_EQ(cuts_.size(), 2U);
    EXPECT_EQ(cuts_[1][0], 520);
    EXPECT_NEAR(cuts_[1][2], 100, 1e-9);
}

TEST_F(CollisionAvoidance, AppliesProgramOrigin) {
    path::Program program = cuts_at({{100, 100, 40}, {300, 100, 40}});
    const LinkingResult linking =
        lead(program, box("clamp", "20, 100, 160", 410, 300, 80), {{'X', 200}, {'Y', 200}, {'Z', 60}});
    EXPECT_EQ(linking.changed, 1U);
    EXPECT_EQ(contacts_, 0U);
    EXPECT_GE(least_mm_, 3 - 1e-6);
    EXPECT_EQ(cuts_[1][0], 520);
}

// With a roof over both cuts and a wall between them, the clear path is neither straight nor up.
TEST_F(CollisionAvoidance, ReroutesPastWallUnderRoof) {
    path::Program program = cuts_at(kTwo);
    const std::string objects = box("wall", "20, 300, 160", 410, 300, 80) +  // y from 150 to 450
                                box("roof", "700, 360, 20", 410, 300, 205);  // from z = 195 on
    const LinkingResult linking = lead(program, objects);
    EXPECT_TRUE(linking.errors.empty());
    EXPECT_EQ(contacts_, 0U);
    EXPECT_GE(least_mm_, 3 - 1e-6);
}

TEST_F(CollisionAvoidance, KeepsToolAxisAfterRerouting) {
    const double half = std::sqrt(0.5);
    path::Program program = cuts_at(kTwo, {{half, 0, half}});
    const LinkingResult linking = lead(program, box("clamp", "20, 100, 160", 430, 300, 80));
    EXPECT_TRUE(linking.errors.empty());
    EXPECT_EQ(contacts_, 0U);
    for (const AxisValues& axes : cuts_)
        EXPECT_LT((space_->tool_axis(axes) - Eigen::Vector3d(half, 0, half)).norm(), 1e-9);
    EXPECT_EQ(cuts_.size(), 2U);
}

// Each axis moves independently: X arrives long before B has turned, so the path is not the straight one.
TEST_F(CollisionAvoidance, ChecksActualPathOfUncoordinatedRapids) {
    machine_ = pin_machine(false);
    path::Program program = cuts_at({{300, 300, 100}, {500, 380, 100}});
    // The post is on neither straight path, but next to it: X and Y first move at the same speed, at 45
    // degrees.
    const LinkingResult linking = lead(program, box("post", "10, 10, 200", 392, 372, 100));
    EXPECT_EQ(linking.changed, 1U);
    EXPECT_EQ(contacts_, 0U);
    EXPECT_GE(least_mm_, 3 - 1e-6);
    machine_ = pin_machine(true);
    path::Program straight = cuts_at({{300, 300, 100}, {500, 380, 100}});
    EXPECT_EQ(lead(straight, box("post", "10, 10, 200", 392, 372, 100)).changed, 0U);
}

TEST_F(CollisionAvoidance, ReportsCutBlockedByClamp) {
    path::Program program = cuts_at(kTwo);
    const LinkingResult linking = lead(program, box("clamp", "10, 100, 160", 518, 300, 80));
    ASSERT_EQ(linking.errors.size(), 1U);
    EXPECT_EQ(program.paths[linking.errors[0].where.path].name, "contour 2");
    EXPECT_NE(linking.errors[0].message.find("'pin' touches 'clamp'"), std::string::npos)
        << linking.errors[0].message;
}

// The pin passes over it, the jet does not.
TEST_F(CollisionAvoidance, ChecksJetWhileProcessIsOn) {
    path::Program program = cuts_at(kTwo);
    const LinkingResult linking = lead(program, box("cable", "4, 100, 4", 510, 300, 90));
    ASSERT_EQ(linking.errors.size(), 1U);
    EXPECT_NE(linking.errors[0].message.find("'jet' touches 'cable'"), std::string::npos)
        << linking.errors[0].message;
}

TEST_F(CollisionAvoidance, ReportsUnreachableEnclosedPosition) {
    path::Program program = cuts_at(kTwo);
    std::string walls = box("lid", "200, 200, 10", 510, 300, 200);
    walls += box("w1", "10, 200, 210", 415, 300, 95) + box("w2", "10, 200, 210", 605, 300, 95);
    walls += box("w3", "200, 10, 210", 510, 205, 95) + box("w4", "200, 10, 210", 510, 395, 95);
    walls += box("floor", "200, 200, 10", 510, 300, 0);
    const LinkingResult linking = lead(program, walls);
    ASSERT_FALSE(linking.errors.empty());
    EXPECT_EQ(program.paths[linking.errors[0].where.path].name, "contour 2");
    EXPECT_NE(linking.errors[0].message.find("no collision-free path"), std::string::npos);
}

// The end of the last path leads up into a body, but no move needs to reach it.
TEST_F(CollisionAvoidance, RetractAfterLastCutAvoidsContact) {
    path::Program program = cuts_at(kTwo);
    const LinkingResult linking = lead(program, box("beam", "20, 100, 20", 520, 300, 195));  // from 185 on
    EXPECT_TRUE(linking.errors.empty()) << linking.errors.front().message;
    EXPECT_EQ(contacts_, 0U);
}

}  // namespace
}  // namespace gsim::linking::clear_ways_test
