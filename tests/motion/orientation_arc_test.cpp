// The great circle in the joints of a head, against its direction in space.

#include "motion/path/orientation_arc.h"

#include <gtest/gtest.h>

#include "tests/motion/machines.h"

namespace gsim::motion::orientation_arc_test {
namespace {

using Eigen::Vector3d;

constexpr double kDirection = 1e-9;

/// The head of the gantry: joint 3 turns about the vertical, joint 4 tilts.
class OrientationArcs : public testing::Test {
  protected:
    Vector3d direction(double turn, double tilt) const {
        return setup.kinematics->forward(joint_pos({0, 0, 0, turn, tilt})).linear().col(2);
    }
    tl::expected<OrientationArc, OrientationError> arc(HeadAngles start, HeadAngles end) const {
        return OrientationArc::between(head, joint_pos({0, 0, 0, start.turn, start.tilt}),
                                       joint_pos({0, 0, 0, end.turn, end.tilt}));
    }
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    /// Many orders of magnitude, so that some lie near the pole.
    double tilt() { return kPi / 2 * std::exp(-uniform(0, 1) * uniform(0, 9)); }
    HeadAngles pose() { return {uniform(-3, 3), tilt()}; }

    void expect_on_circle(const OrientationArc& arc_path, HeadAngles start, HeadAngles end) const {
        const Vector3d from = direction(start.turn, start.tilt);
        const Vector3d to = direction(end.turn, end.tilt);
        const Vector3d ahead = (to - from * from.dot(to)).normalized();
        for (int i = 0; i <= 50; ++i) {
            const double angle = arc_path.length_rad() * i / 50;
            const HeadAngles at = arc_path.at(angle).angles;
            const Vector3d expected_value = std::cos(angle) * from + std::sin(angle) * ahead;
            ASSERT_LT((direction(at.turn, at.tilt) - expected_value).norm(), kDirection)
                << start.turn << " " << start.tilt << " to " << end.turn << " " << end.tilt;
        }
    }

    const PlannerSetup setup = gantry_setup();
    const kinematics::TiltingHead head = setup.kinematics->tilting_head().value();
    std::mt19937 random{3};
};

TEST_F(OrientationArcs, MoveEvenlyAlongGreatCircleWithExactEnds) {
    int found = 0;
    for (int i = 0; i < 1000; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        HeadAngles start = pose();
        HeadAngles end = pose();
        start.tilt *= side;
        end.tilt *= side;
        const auto arc_path = arc(start, end);
        ASSERT_EQ(arc_path.has_value(), std::abs(end.turn - start.turn) < kPi);
        if (!arc_path) continue;
        ++found;
        expect_on_circle(*arc_path, start, end);
        EXPECT_NEAR(arc_path->length_rad(),
                    std::acos(direction(start.turn, start.tilt).dot(direction(end.turn, end.tilt))), 1e-7);
        EXPECT_EQ(arc_path->at(0).angles.turn, start.turn);
        EXPECT_EQ(arc_path->at(0).angles.tilt, start.tilt);
        EXPECT_NEAR(arc_path->at(arc_path->length_rad()).angles.turn, end.turn, 1e-13);
        EXPECT_NEAR(arc_path->at(arc_path->length_rad()).angles.tilt, end.tilt, 1e-13);
    }
    EXPECT_GT(found, 500);
}

TEST_F(OrientationArcs, FollowGreatCircleOverShortDistances) {
    for (int i = 0; i < 500; ++i) {
        const HeadAngles start = pose();
        const double small = std::exp(-uniform(1, 14));
        const HeadAngles end{start.turn + small * uniform(-1, 1), start.tilt * (1 + small * uniform(-1, 1))};
        const auto arc_path = arc(start, end);
        if (std::acos(std::min(1.0, direction(start.turn, start.tilt).dot(direction(end.turn, end.tilt)))) <
            1e-7)
            continue;
        ASSERT_TRUE(arc_path) << static_cast<int>(arc_path.error());
        expect_on_circle(*arc_path, start, end);
    }
}

TEST_F(OrientationArcs, DerivativesMatchSlopesWithinBounds) {
    for (int i = 0; i < 300; ++i) {
        const auto arc_path = arc(pose(), {uniform(-1, 1), uniform(0.05, kPi / 2)});
        if (!arc_path) continue;
        const HeadBounds bounds = arc_path->bounds();
        const double h = arc_path->length_rad() / 400;
        double first = std::max(std::abs(arc_path->at(0).first.turn),
                                std::abs(arc_path->at(arc_path->length_rad()).first.turn));
        const auto derivative = [&](double at, double HeadAngles::*joint, HeadAngles HeadState::*of) {
            return ((arc_path->at(at + h).*of).*joint - (arc_path->at(at - h).*of).*joint) / (2 * h);
        };
        for (int k = 1; k < 400; ++k) {
            const double at = k * h;
            const HeadState state = arc_path->at(at);
            for (const auto joint : {&HeadAngles::turn, &HeadAngles::tilt}) {
                ASSERT_LE(std::abs(state.first.*joint), bounds.first.*joint * (1 + 1e-9));
                ASSERT_LE(std::abs(state.second.*joint), bounds.second.*joint * (1 + 1e-9));
                const double third = derivative(at, joint, &HeadState::second);
                ASSERT_LE(std::abs(third), bounds.third.*joint * (1 + 1e-6) + 1e-6);
                // Over 2 h a slope changes by its own derivatives: the possible error of a difference.
                ASSERT_NEAR(derivative(at, joint, &HeadState::angles), state.first.*joint,
                            h * h * bounds.third.*joint + 1e-6);
                ASSERT_NEAR(derivative(at, joint, &HeadState::first), state.second.*joint,
                            2 * h * bounds.third.*joint + 1e-6);
            }
            first = std::max(first, std::abs(state.first.turn));
        }
        if (bounds.first.turn < 5) {
            EXPECT_GT(first, 0.9 * bounds.first.turn) << "the bound is no looser than need be";
        }
    }
}

// Clairaut: the turn is fastest if the circle is nearest to the pole, by 1 / sin(tilt).
TEST_F(OrientationArcs, TurnFastestNearPole) {
    const auto arc_path = arc({-1, 0.4}, {1, 0.4});
    ASSERT_TRUE(arc_path);
    const double nearest = std::atan(std::tan(0.4) * std::cos(1));  // of a right-angled triangle
    const HeadState middle = arc_path->at(arc_path->length_rad() / 2);
    EXPECT_NEAR(middle.angles.tilt, nearest, 1e-12);
    EXPECT_NEAR(middle.angles.turn, 0, 1e-12);
    EXPECT_NEAR(middle.first.turn, 1 / std::sin(nearest), 1e-12);
    EXPECT_NEAR(arc_path->bounds().first.turn, 1 / std::sin(nearest), 1e-12);
    EXPECT_NEAR(arc_path->tilt_range().min, nearest, 1e-12);
    EXPECT_NEAR(arc_path->tilt_range().max, 0.4, 1e-12);
}

TEST_F(OrientationArcs, TiltRangeMatchesDenseSamples) {
    for (int i = 0; i < 300; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        HeadAngles start{uniform(-1.5, 1.5), side * uniform(0.05, 3)};
        HeadAngles end{uniform(-1.5, 1.5), side * uniform(0.05, 3)};
        const auto arc_path = arc(start, end);
        ASSERT_TRUE(arc_path);
        const Range range = arc_path->tilt_range();
        double min = start.tilt;
        double max = start.tilt;
        for (int k = 0; k <= 2000; ++k) {
            const double tilt = arc_path->at(arc_path->length_rad() * k / 2000).angles.tilt;
            min = std::min(min, tilt);
            max = std::max(max, tilt);
        }
        EXPECT_LE(range.min, min + 1e-12);
        EXPECT_GE(range.max, max - 1e-12);
        EXPECT_NEAR(range.min, min, 1e-4);
        EXPECT_NEAR(range.max, max, 1e-4);
    }
}

TEST_F(OrientationArcs, TiltChangesSignThroughPole) {
    const HeadAngles start{0.3, -0.5};
    const HeadAngles end{0.3, 0.8};
    const auto arc_path = arc(start, end);
    ASSERT_TRUE(arc_path);
    expect_on_circle(*arc_path, start, end);
    EXPECT_NEAR(arc_path->at(0.5).angles.tilt, 0, 1e-15);
    EXPECT_EQ(arc_path->at(0.7).angles.turn, 0.3);
    EXPECT_EQ(arc_path->bounds().first.turn, 0);
    EXPECT_EQ(arc_path->bounds().first.tilt, 1);
}

TEST_F(OrientationArcs, PartsLieOnCompleteArc) {
    const auto arc_path = arc({-1.2, 0.9}, {1, 0.2});
    ASSERT_TRUE(arc_path);
    const double from = arc_path->length_rad() * 0.3;
    const OrientationArc part = arc_path->part(from, arc_path->length_rad() * 0.8).part(0.01, 0.2);
    EXPECT_NEAR(part.length_rad(), 0.19, 1e-15);
    for (const double at : {0.0, 0.1, 0.19}) {
        EXPECT_NEAR(part.at(at).angles.turn, arc_path->at(from + 0.01 + at).angles.turn, 1e-15);
        EXPECT_NEAR(part.at(at).angles.tilt, arc_path->at(from + 0.01 + at).angles.tilt, 1e-15);
    }
    EXPECT_LE(part.bounds().first.turn, arc_path->bounds().first.turn);
}

TEST_F(OrientationArcs, ReportReasonOfImpossibleArc) {
    const auto reason = [&](HeadAngles start, HeadAngles end) {
        const auto arc_path = arc(start, end);
        EXPECT_FALSE(arc_path);
        return arc_path ? OrientationError{} : arc_path.error();
    };
    EXPECT_EQ(reason({0, kPi / 2}, {kPi, kPi / 2}), OrientationError::opposite);
    EXPECT_EQ(reason({0, kPi / 2}, {0, -kPi / 2}), OrientationError::opposite);
    EXPECT_EQ(reason({0, 0.5}, {2 * kPi, 0.5}), OrientationError::same) << "a whole turn";
    EXPECT_EQ(reason({0, 0.5}, {kPi, -0.5}), OrientationError::same) << "the other branch";
    EXPECT_EQ(reason({0, 0}, {1, 0.5}), OrientationError::at_pole);
    EXPECT_EQ(reason({0, 0.5}, {1, 0}), OrientationError::at_pole);
    EXPECT_EQ(reason({0, 0.5}, {kPi, 0.4}), OrientationError::different_solution) << "through the pole";
    EXPECT_EQ(reason({0, 0.5}, {0.2, -0.4}), OrientationError::different_solution) << "the other branch";
    EXPECT_EQ(reason({0, 0.5}, {1 + 2 * kPi, 0.4}), OrientationError::different_solution)
        << "a whole turn more";
    EXPECT_TRUE(arc({0, 0}, {0, 0.5})) << "from the pole along a meridian";
}

}  // namespace
}  // namespace gsim::motion::orientation_arc_test
