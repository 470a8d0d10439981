#include "analysis/envelope/outline.h"

#include <gtest/gtest.h>

#include "tests/analysis/envelope/chains.h"

namespace gsim::envelope::outline_test {
namespace {

double area_mm2(const Curve& curve) {
    Vector3d sum = Vector3d::Zero();
    const std::size_t count = curve.points_mm.size();
    for (std::size_t i = 0; i < count; ++i)
        sum += curve.points_mm[i].cross(curve.points_mm[(i + 1) % count]) / 2;
    return sum.norm();
}

TEST(Outline, TwoJointsReachAnnulus) {
    const auto outlines = pair_outlines(planar_arm(), rrs::JointPos::Zero(2));
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_TRUE(outlines[0].flat);
    ASSERT_EQ(outlines[0].curves.size(), 2U);
    double outer = area_mm2(outlines[0].curves[0]);
    double inner = area_mm2(outlines[0].curves[1]);
    if (outer < inner) std::swap(outer, inner);
    EXPECT_NEAR(outer, kPi * 500 * 500, 0.002 * outer);
    EXPECT_NEAR(inner, kPi * 100 * 100, 0.005 * inner);
    for (const Curve& curve : outlines[0].curves) {
        for (const Vector3d& point : curve.points_mm)
            EXPECT_LT(std::min(500 - point.norm(), point.norm() - 100), outlines[0].error_mm);
    }
}

// From -60 to 60 degrees each: the sector of the stretched arm, less what the elbow cannot come to.
TEST(Outline, ContainsReachableTcpPositions) {
    const TcpChain arm = planar_arm(-kPi / 3, kPi / 3);
    const auto outlines = pair_outlines(arm, rrs::JointPos::Zero(2));
    ASSERT_EQ(outlines[0].curves.size(), 1U);
    const std::vector<Vector3d>& border = outlines[0].curves[0].points_mm;
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const Vector3d tcp = random_tip(arm, random);
        double turned = 0;
        double min = 1e9;
        for (std::size_t k = 0; k < border.size(); ++k) {
            const Vector3d a = border[k] - tcp;
            const Vector3d b = border[(k + 1) % border.size()] - tcp;
            turned += std::atan2(a.cross(b).y(), a.dot(b));
            min = std::min(min, a.norm());
        }
        EXPECT_TRUE(std::abs(turned) > kPi || min < outlines[0].error_mm + 5);
    }
}

TEST(Outline, IsParallelogramForTwoLinearAxes) {
    const TcpChain chain{{slide(0, Vector3d::UnitX(), 0, 30), slide(1, Vector3d::UnitY(), -10, 10)},
                         {0, 0, 7}};
    const auto outlines = pair_outlines(chain, rrs::JointPos::Zero(2));
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].error_mm, 0);
    EXPECT_NEAR(area_mm2(outlines[0].curves[0]), 600, 1e-9);
    EXPECT_TRUE(outlines[0].curves[0].points_mm[2].isApprox(Vector3d(30, 10, 7)));
}

TEST(Outline, CurvedSurfaceHasCurvesAtJointLimits) {
    const auto all = pair_outlines(elbow_arm(), rrs::JointPos::Zero(3));
    ASSERT_EQ(all.size(), 3U);
    EXPECT_FALSE(all[0].flat);
    EXPECT_TRUE(all[0].curves.empty());  // both turn all round: a torus
    TcpChain part = elbow_arm();
    part.joints[0].high = 0;
    EXPECT_EQ(pair_outlines(part, rrs::JointPos::Zero(3))[0].curves.size(), 2U);
}

}  // namespace
}  // namespace gsim::envelope::outline_test
