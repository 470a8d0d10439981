#include "engine/pose.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/build_files/build_files.h"
#include "tests/engine/given.h"

namespace gsim::engine::pose_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Values = std::vector<double>;

Machine machine_of(const std::string& file) {
    Request request;
    request.machine = file;
    return Machine::read(request).value();
}

Machine sample(const std::string& name) {
    return machine_of(tests::source_path("samples/machines/") + name);
}

std::vector<std::string> sample_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(tests::source_path("samples/machines")))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
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
        PoseChoice home;
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
        PoseChoice wrong;
        wrong.joints = Values(1000, 0);
        const std::string sentence = pose_of(machine_, wrong).error().message;
        return std::stoul(sentence.substr(sentence.find("have ") + 5));
    }

    // Returns the end by bisection, or a bound if the axis has no end.
    double end(std::size_t axis, int side) const {
        constexpr double kFar = 400;
        double within = 0;
        double beyond = side * kFar;
        if (state(axis, beyond) != side) return beyond;
        for (int i = 0; i < 60; ++i) {
            const double middle = (within + beyond) / 2;
            (state(axis, middle) == side ? beyond : within) = middle;
        }
        return within;
    }

    int state(std::size_t axis, double value) const {
        PoseChoice choice;
        choice.joints = Values(count(), 0);
        (*choice.joints)[axis] = value;
        return pose_of(machine_, choice)->beyond[axis];
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
    double most = 0;
    const auto one = matrix(a_deg), other = matrix(b_deg);
    for (std::size_t i = 0; i < one.size(); ++i) most = std::max(most, std::abs(one[i] - other[i]));
    return most;
}

TEST(Poses, TheInverseLeadsBackOnAllSampleMachines) {
    std::size_t with_inverse = 0;
    std::mt19937 random(20);
    for (const std::string& name : sample_names()) {
        const Machine machine = sample(name);
        const Ranges ranges(machine);
        PoseChoice choice;
        choice.tool_mm = 37.5;
        for (int i = 0; i < 25; ++i) {
            choice.joints = ranges.any(random);
            const Pose there = pose_of(machine, choice).value();
            EXPECT_EQ(there.joints, *choice.joints);
            PoseChoice back{.tip_mm = there.tip_mm, .rpy_deg = there.rpy_deg, .tool_mm = 37.5};
            back.near = ranges.any(random);
            for (const std::size_t axis : axes_of_groups(name)) (*back.near)[axis] = there.joints[axis];
            const auto found = pose_of(machine, back);
            if (!found && found.error().message.find("no inverse") != std::string::npos) {
                EXPECT_EQ(there.solutions, std::vector<Values>{*choice.joints});
                continue;
            }
            ASSERT_TRUE(found) << name << ": " << found.error().message;
            ++with_inverse;
            EXPECT_LT(distance(found->tip_mm, there.tip_mm), 1e-6) << name;
            EXPECT_LT(turn_between(found->rpy_deg, there.rpy_deg), 1e-8) << name;
            EXPECT_THAT(found->beyond, testing::Each(0)) << name;
            ASSERT_FALSE(found->solutions.empty());
            EXPECT_EQ(found->solutions.front(), found->joints);
            for (const Values& solution : found->solutions) {
                const Pose each = pose_of(machine, {.joints = solution, .tool_mm = 37.5}).value();
                EXPECT_LT(distance(each.tip_mm, there.tip_mm), 1e-6) << name;
                EXPECT_LT(distance(each.tool_axis, there.tool_axis), 1e-8) << name;
            }
        }
    }
    EXPECT_GT(with_inverse, 200U);
}

TEST(Poses, TheTipIsBelowTheToolByItsLength) {
    const Machine machine = sample("mill-head-table.toml");
    PoseChoice choice;
    choice.joints = Values{10, 20, 30, 40, 50};
    const Pose without = pose_of(machine, choice).value();
    choice.tool_mm = 100;
    const Pose with = pose_of(machine, choice).value();
    EXPECT_NEAR(distance(with.tip_mm, without.tip_mm), 100, 1e-9);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(with.tip_mm[i], without.tip_mm[i] - 100 * with.tool_axis[i], 2e-9);
}

TEST(Poses, AToolAxisLeavesTheTurnAboutItToWhatIsNear) {
    const Machine arm = sample("arm6.toml");
    PoseChoice choice;
    choice.joints = Values{10, 60, -100, 30, 60, 20};
    const Pose start = pose_of(arm, choice).value();
    choice = {.tip_mm = start.tip_mm, .tool_axis = start.tool_axis, .near = start.joints};
    (*choice.tip_mm)[0] += 1e-3;
    const auto found = pose_of(arm, choice);
    ASSERT_TRUE(found) << found.error().message;
    const Pose moved = *found;
    for (std::size_t i = 0; i < start.joints.size(); ++i)
        EXPECT_NEAR(moved.joints[i], start.joints[i], 0.01) << i;
    choice.tool_axis =
        std::array{5 * start.tool_axis[0], 5 * start.tool_axis[1] + 0.5, 5 * start.tool_axis[2]};
    const auto leaning = pose_of(arm, choice);
    ASSERT_TRUE(leaning) << leaning.error().message;
    EXPECT_NEAR(leaning->tool_axis[0] / leaning->tool_axis[2], start.tool_axis[0] / start.tool_axis[2], 1e-9);
    EXPECT_GT(leaning->tool_axis[1], start.tool_axis[1] + 0.01);
}

TEST(Poses, WithoutAnOrientationTheToolStandsAsNear) {
    const Machine machine = Machine::read({}).value();
    PoseChoice choice{.tip_mm = {{500, 400, 100}}};
    choice.near = Values{500, 500, 100, 0, 30};
    const Pose pose = pose_of(machine, choice).value();
    const Pose near = pose_of(machine, {.joints = choice.near}).value();
    EXPECT_LT(distance(pose.tool_axis, near.tool_axis), 1e-9);
    EXPECT_LT(distance(pose.tip_mm, *choice.tip_mm), 1e-9);
}

TEST(Poses, WhatIsBeyondARangeIsTold) {
    const Machine machine = sample("router3.toml");
    const Pose pose = pose_of(machine, {.joints = Values{-1, 100, 0.5}}).value();
    EXPECT_THAT(pose.beyond, ElementsAre(-1, 0, 1));
    EXPECT_THAT(pose_of(machine, {.tip_mm = {{601, 400, -120}}})->beyond, ElementsAre(1, 0, 0));
}

TEST(Poses, BodiesThatTouchAreNamedOnceTheyAreRead) {
    Request request;
    request.cell = tests::source_path("samples/cell/table.toml");
    Machine machine = Machine::read(request).value();
    PoseChoice in_clamp{.tip_mm = {{100, 400, 10}}};
    EXPECT_TRUE(pose_of(machine, in_clamp)->collisions.empty());
    ASSERT_TRUE(machine.read_bodies());
    const auto collisions = pose_of(machine, in_clamp)->collisions;
    EXPECT_THAT(collisions, testing::Contains(std::pair<std::string, std::string>("nozzle", "left clamp")));
    EXPECT_TRUE(pose_of(machine, {.tip_mm = {{600, 400, 200}}})->collisions.empty());
}

std::string fault(const Machine& machine, const PoseChoice& choice) {
    const auto pose = pose_of(machine, choice);
    return pose ? "none" : pose.error().code + ": " + pose.error().message;
}

TEST(Poses, WhatCannotBeIsToldInASentence) {
    const Machine machine = sample("router3.toml");
    constexpr std::array<double, 3> kPoint{1, 2, 3};
    EXPECT_EQ(fault(machine, {}), "usage: a pose is told by 'joints' or by 'tip_mm', by one of them");
    EXPECT_EQ(fault(machine, {.joints = Values{1, 2, 3}, .tip_mm = kPoint}),
              "usage: a pose is told by 'joints' or by 'tip_mm', by one of them");
    EXPECT_EQ(fault(machine, {.joints = Values{1, 2}}),
              "usage: 'joints' should have 3 values, one for each axis of the machine, not 2");
    EXPECT_EQ(fault(machine, {.tip_mm = kPoint, .near = Values{1}}),
              "usage: 'near' should have 3 values, one for each axis of the machine, not 1");
    EXPECT_EQ(fault(machine, {.joints = Values{1, 2, 3}, .rpy_deg = kPoint}),
              "usage: 'tool_axis' and 'rpy_deg' go with 'tip_mm', not with 'joints'");
    EXPECT_EQ(fault(machine, {.tip_mm = kPoint, .tool_axis = kPoint, .rpy_deg = kPoint}),
              "usage: 'tool_axis' and 'rpy_deg' do not go together");
    EXPECT_EQ(fault(machine, {.tip_mm = kPoint, .tool_axis = {{0, 0, 0}}}),
              "usage: 'tool_axis' has no length, so that it has no direction");
    EXPECT_THAT(fault(machine, {.tip_mm = kPoint, .tool_axis = {{1, 0, 1}}}), HasSubstr("unreachable: "));
    EXPECT_THAT(fault(sample("arm6.toml"), {.tip_mm = {{1e6, 0, 0}}}), HasSubstr("unreachable: "));
    EXPECT_THAT(fault(sample("linuxcnc-router.toml"), {.tip_mm = kPoint}),
                HasSubstr("unreachable: This machine has no inverse"));
}

}  // namespace
}  // namespace gsim::engine::pose_test
