#include "engine/pose.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/build_files/build_files.h"
#include "tests/engine/memory_files.h"
#include "tests/support/machine_path.h"

namespace gsim::engine::pose_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Values = std::vector<double>;

Machine make_machine(const std::string& file) {
    Request request;
    request.machine = file;
    return Machine::read(request).value();
}

Machine sample(const std::string& name) {
    return make_machine(tests::machine_path(name).string());
}

std::vector<std::string> sample_names() {
    std::vector<std::string> names;
    for (const std::filesystem::path& file : tests::machine_files())
        names.push_back(file.filename().string());
    return names;
}

/// Returns the axes that the inverse leaves unchanged.
std::vector<std::size_t> axes_of_groups(const std::string& name) {
    return name == "arm6-cell.toml" ? std::vector<std::size_t>{0, 7} : std::vector<std::size_t>{};
}

/// Ranges of axes are felt by what is beyond them.
class Ranges {
  public:
    explicit Ranges(const Machine& machine) : machine_(machine) {
        PoseRequest home;
        home.joints = Values(count(), 0);
        for (std::size_t axis = 0; axis < count(); ++axis) ranges_.push_back({end(axis, -1), end(axis, 1)});
    }

    Values any(std::mt19937& random) const {
        Values values;
        for (const auto& [low, high] : ranges_)
            values.push_back(std::uniform_real_distribution<double>(low, high)(random));
        return values;
    }

  private:
    std::size_t count() const {
        PoseRequest wrong;
        wrong.joints = Values(1000, 0);
        const std::string message = solve_pose(machine_, wrong).error().message;
        return std::stoul(message.substr(message.find("have ") + 5));
    }

    // Returns the end by bisection, or a bound if the axis has no end.
    double end(std::size_t axis, int side) const {
        constexpr double kFar = 400;
        double within = 0;
        double out_of_range = side * kFar;
        if (state(axis, out_of_range) != side) return out_of_range;
        for (int i = 0; i < 60; ++i) {
            const double middle = (within + out_of_range) / 2;
            (state(axis, middle) == side ? out_of_range : within) = middle;
        }
        return within;
    }

    int state(std::size_t axis, double value) const {
        PoseRequest pose_request;
        pose_request.joints = Values(count(), 0);
        (*pose_request.joints)[axis] = value;
        return solve_pose(machine_, pose_request)->out_of_range[axis];
    }

    const Machine& machine_;
    std::vector<std::pair<double, double>> ranges_;
};

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Angles of rpy may differ for the same rotation.
double turn_between(const std::array<double, 3>& a_deg, const std::array<double, 3>& b_deg) {
    const auto matrix = [](const std::array<double, 3>& deg) {
        const double r = deg[0] * M_PI / 180, p = deg[1] * M_PI / 180, y = deg[2] * M_PI / 180;
        return std::array{std::cos(r) * std::cos(p),
                          std::sin(r) * std::cos(p),
                          -std::sin(p),
                          std::cos(r) * std::sin(p) * std::sin(y) - std::sin(r) * std::cos(y),
                          std::sin(r) * std::sin(p) * std::sin(y) + std::cos(r) * std::cos(y),
                          std::cos(p) * std::sin(y)};
    };
    double max = 0;
    const auto one = matrix(a_deg), other = matrix(b_deg);
    for (std::size_t i = 0; i < one.size(); ++i) max = std::max(max, std::abs(one[i] - other[i]));
    return max;
}

TEST(Poses, InverseReproducesPoseOnAllSampleMachines) {
    std::size_t with_inverse = 0;
    std::mt19937 random(20);
    for (const std::string& name : sample_names()) {
        const Machine machine = sample(name);
        const Ranges ranges(machine);
        PoseRequest pose_request;
        pose_request.tool_mm = 37.5;
        for (int i = 0; i < 25; ++i) {
            pose_request.joints = ranges.any(random);
            const Pose there = solve_pose(machine, pose_request).value();
            EXPECT_EQ(there.joints, *pose_request.joints);
            PoseRequest back{.tcp_mm = there.tcp_mm, .rpy_deg = there.rpy_deg, .tool_mm = 37.5};
            back.near = ranges.any(random);
            for (const std::size_t axis : axes_of_groups(name)) (*back.near)[axis] = there.joints[axis];
            const auto found = solve_pose(machine, back);
            if (!found && found.error().message.find("no inverse") != std::string::npos) {
                EXPECT_EQ(there.solutions, std::vector<Values>{*pose_request.joints});
                continue;
            }
            ASSERT_TRUE(found) << name << ": " << found.error().message;
            ++with_inverse;
            EXPECT_LT(distance(found->tcp_mm, there.tcp_mm), 1e-6) << name;
            EXPECT_LT(turn_between(found->rpy_deg, there.rpy_deg), 1e-8) << name;
            EXPECT_THAT(found->out_of_range, testing::Each(0)) << name;
            ASSERT_FALSE(found->solutions.empty());
            EXPECT_EQ(found->solutions.front(), found->joints);
            for (const Values& solution : found->solutions) {
                const Pose each = solve_pose(machine, {.joints = solution, .tool_mm = 37.5}).value();
                EXPECT_LT(distance(each.tcp_mm, there.tcp_mm), 1e-6) << name;
                EXPECT_LT(distance(each.tool_axis, there.tool_axis), 1e-8) << name;
            }
        }
    }
    EXPECT_GT(with_inverse, 200U);
}

TEST(Poses, TcpIsOffsetByToolLength) {
    const Machine machine = sample("mill-head-table.toml");
    PoseRequest pose_request;
    pose_request.joints = Values{10, 20, 30, 40, 50};
    const Pose without = solve_pose(machine, pose_request).value();
    pose_request.tool_mm = 100;
    const Pose with = solve_pose(machine, pose_request).value();
    EXPECT_NEAR(distance(with.tcp_mm, without.tcp_mm), 100, 1e-9);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(with.tcp_mm[i], without.tcp_mm[i] - 100 * with.tool_axis[i], 2e-9);
}

TEST(Poses, ToolAxisKeepsRotationOfNearConfiguration) {
    const Machine arm = sample("arm6.toml");
    PoseRequest pose_request;
    pose_request.joints = Values{10, 60, -100, 30, 60, 20};
    const Pose start = solve_pose(arm, pose_request).value();
    pose_request = {.tcp_mm = start.tcp_mm, .tool_axis = start.tool_axis, .near = start.joints};
    (*pose_request.tcp_mm)[0] += 1e-3;
    const auto found = solve_pose(arm, pose_request);
    ASSERT_TRUE(found) << found.error().message;
    const Pose moved = *found;
    for (std::size_t i = 0; i < start.joints.size(); ++i)
        EXPECT_NEAR(moved.joints[i], start.joints[i], 0.01) << i;
    pose_request.tool_axis =
        std::array{5 * start.tool_axis[0], 5 * start.tool_axis[1] + 0.5, 5 * start.tool_axis[2]};
    const auto leaning = solve_pose(arm, pose_request);
    ASSERT_TRUE(leaning) << leaning.error().message;
    EXPECT_NEAR(leaning->tool_axis[0] / leaning->tool_axis[2], start.tool_axis[0] / start.tool_axis[2], 1e-9);
    EXPECT_GT(leaning->tool_axis[1], start.tool_axis[1] + 0.01);
}

TEST(Poses, KeepsNearToolAxisWithoutOrientation) {
    const Machine machine = Machine::read({}).value();
    PoseRequest pose_request{.tcp_mm = {{500, 400, 100}}};
    pose_request.near = Values{500, 500, 100, 0, 30};
    const Pose pose = solve_pose(machine, pose_request).value();
    const Pose near = solve_pose(machine, {.joints = pose_request.near}).value();
    EXPECT_LT(distance(pose.tool_axis, near.tool_axis), 1e-9);
    EXPECT_LT(distance(pose.tcp_mm, *pose_request.tcp_mm), 1e-9);
}

TEST(Poses, ReportsAxesOutOfRange) {
    const Machine machine = sample("router3.toml");
    const Pose pose = solve_pose(machine, {.joints = Values{-1, 100, 0.5}}).value();
    EXPECT_THAT(pose.out_of_range, ElementsAre(-1, 0, 1));
    EXPECT_THAT(solve_pose(machine, {.tcp_mm = {{601, 400, -120}}})->out_of_range, ElementsAre(1, 0, 0));
}

TEST(Poses, ReportsCollisionsAfterBodiesAreRead) {
    Request request;
    request.cell = tests::source_path("samples/cell/table.toml");
    Machine machine = Machine::read(request).value();
    PoseRequest in_clamp{.tcp_mm = {{100, 400, 10}}};
    EXPECT_TRUE(solve_pose(machine, in_clamp)->collisions.empty());
    ASSERT_TRUE(machine.read_bodies());
    const auto collisions = solve_pose(machine, in_clamp)->collisions;
    EXPECT_THAT(collisions, testing::Contains(std::pair<std::string, std::string>("nozzle", "left clamp")));
    EXPECT_TRUE(solve_pose(machine, {.tcp_mm = {{600, 400, 200}}})->collisions.empty());
}

std::string error(const Machine& machine, const PoseRequest& pose_request) {
    const auto pose = solve_pose(machine, pose_request);
    return pose ? "none" : pose.error().code + ": " + pose.error().message;
}

TEST(Poses, RejectsInvalidOrUnreachablePose) {
    const Machine machine = sample("router3.toml");
    constexpr std::array<double, 3> kPoint{1, 2, 3};
    EXPECT_EQ(error(machine, {}), "usage: a pose must have either 'joints' or 'tip_mm'");
    EXPECT_EQ(error(machine, {.joints = Values{1, 2, 3}, .tcp_mm = kPoint}),
              "usage: a pose must have either 'joints' or 'tip_mm'");
    EXPECT_EQ(error(machine, {.joints = Values{1, 2}}),
              "usage: 'joints' must have 3 values, one for each axis of the machine, not 2");
    EXPECT_EQ(error(machine, {.tcp_mm = kPoint, .near = Values{1}}),
              "usage: 'near' must have 3 values, one for each axis of the machine, not 1");
    EXPECT_EQ(error(machine, {.joints = Values{1, 2, 3}, .rpy_deg = kPoint}),
              "usage: 'tool_axis' and 'rpy_deg' require 'tip_mm', not 'joints'");
    EXPECT_EQ(error(machine, {.tcp_mm = kPoint, .tool_axis = kPoint, .rpy_deg = kPoint}),
              "usage: 'tool_axis' and 'rpy_deg' cannot be combined");
    EXPECT_EQ(error(machine, {.tcp_mm = kPoint, .tool_axis = {{0, 0, 0}}}),
              "usage: 'tool_axis' must have a length greater than 0");
    EXPECT_THAT(error(machine, {.tcp_mm = kPoint, .tool_axis = {{1, 0, 1}}}), HasSubstr("unreachable: "));
    EXPECT_THAT(error(sample("arm6.toml"), {.tcp_mm = {{1e6, 0, 0}}}), HasSubstr("unreachable: "));
    EXPECT_THAT(error(sample("linuxcnc-router.toml"), {.tcp_mm = kPoint}),
                HasSubstr("unreachable: This machine has no inverse"));
}

}  // namespace
}  // namespace gsim::engine::pose_test
