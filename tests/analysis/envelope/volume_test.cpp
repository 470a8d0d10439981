#include "analysis/envelope/volume.h"

#include <map>

#include <gtest/gtest.h>

#include "analysis/envelope/stl.h"
#include "machine/file/machine_file.h"
#include "tests/analysis/envelope/chains.h"
#include "tests/build_files/build_files.h"

namespace gsim::envelope::volume_test {
namespace {

void expect_closed(const Surface& surface) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& [a, b, c] : surface.triangles) {
        for (const auto& edge : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) ++edges[edge];
    }
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

// By the sum of solid angles (Van Oosterom and Strackee, IEEE Trans. Biomedical Engineering 30, 1983).
bool is_inside(const Surface& surface, const Vector3d& point) {
    double angle = 0;
    for (const auto& corners : surface.triangles) {
        const Vector3d a = surface.points_mm[corners[0]] - point;
        const Vector3d b = surface.points_mm[corners[1]] - point;
        const Vector3d c = surface.points_mm[corners[2]] - point;
        angle += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                       b.dot(c) * a.norm() + c.dot(a) * b.norm());
    }
    return angle > 2 * kPi;
}

double distance_of_corners(const Surface& surface, const Vector3d& point) {
    double min = 1e9;
    for (const Vector3d& corner : surface.points_mm) min = std::min(min, (corner - point).norm());
    return min;
}

void expect_tips_within(const TcpChain& chain, const Volume& volume) {
    std::mt19937 random(5);
    for (int i = 0; i < 100; ++i) {
        const Vector3d tcp = random_tip(chain, random);
        EXPECT_TRUE(is_inside(volume.surface, tcp) ||
                    distance_of_corners(volume.surface, tcp) <= volume.error_mm + volume.step_mm);
    }
}

TEST(Volume, ThreeLinearAxesGiveExactBox) {
    const auto machine = machine::load_machine(tests::source_path("samples/machines/router3.toml"));
    const auto chain = envelope_chain(machine.value());
    ASSERT_TRUE(chain) << chain.error().message;
    const Volume volume = reached_volume(*chain);
    EXPECT_EQ(volume.step_mm, 0);
    EXPECT_NEAR(volume_mm3(volume.surface), 600.0 * 400 * 120, 1e-3);
    expect_closed(volume.surface);
    EXPECT_EQ(to_stl(volume.surface).size(), 84U + 12 * 50);
    EXPECT_NE(to_stl(volume.surface).substr(0, 5), "solid");
}

TEST(Volume, ObliqueAndParallelLinearAxesAreExact) {
    const Vector3d oblique = Vector3d(1, 1, 0).normalized();
    const TcpChain chain{{slide(0, Vector3d::UnitZ(), -10, 20), slide(1, oblique, 0, 100),
                          slide(2, Vector3d::UnitX(), 0, 50), slide(3, -Vector3d::UnitZ(), -30, 40)},
                         Vector3d::Zero()};
    const Volume volume = reached_volume(chain);
    EXPECT_NEAR(volume_mm3(volume.surface), 100 * std::sqrt(0.5) * 50 * 100, 1e-6);
    EXPECT_NEAR(volume.surface.points_mm.front().z(), -50, 1e-9);
}

TEST(Volume, ElbowArmReachesShell) {
    const TcpChain arm = elbow_arm();
    const Volume volume = reached_volume(arm, 40);
    expect_closed(volume.surface);
    for (const Vector3d& corner : volume.surface.points_mm) {
        EXPECT_LT(corner.norm(), 500 + 1e-6);
        EXPECT_GT(corner.norm(), 100 - 1e-6);
    }
    EXPECT_LT(volume.error_mm, 200);
    const double shell = 4 * kPi / 3 * (std::pow(500, 3) - std::pow(100, 3));
    EXPECT_NEAR(volume_mm3(volume.surface), shell, 0.02 * shell);
    expect_tips_within(arm, volume);
}

TEST(Volume, RotatedLinearAxisGivesRingSector) {
    const TcpChain chain{{turn(0, Vector3d::Zero(), Vector3d::UnitZ(), 0, kPi / 2),
                          slide(1, Vector3d::UnitZ(), 0, 100), slide(2, Vector3d::UnitX(), 0, 100)},
                         {200, 0, 0}};
    const Volume volume = reached_volume(chain, 40);
    expect_closed(volume.surface);
    const double part = kPi / 4 * (300.0 * 300 - 200.0 * 200) * 100;
    EXPECT_NEAR(volume_mm3(volume.surface), part, 0.05 * part);
    expect_tips_within(chain, volume);
}

TEST(Volume, RejectsUnlimitedRangeAndMachineWithoutMotion) {
    machine::Machine machine =
        machine::load_machine(tests::source_path("samples/machines/router3.toml")).value();
    machine.axes[2].min = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(envelope_chain(machine).error().message,
              "the machine has no envelope: axis Z has an unlimited range");
    for (machine::Axis& axis : machine.axes) axis.min = axis.max = 0;
    EXPECT_EQ(envelope_chain(machine).error().message, "the machine has no envelope: no axis moves the TCP");
}

}  // namespace
}  // namespace gsim::envelope::volume_test
