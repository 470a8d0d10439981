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
    tl::expected<OrientationArc, OrientationFault> arc(HeadAngles start, HeadAngles end) const {
        return OrientationArc::between(head, joint_pos({0, 0, 0, start.turn, start.tilt}),
                                       joint_pos({0, 0, 0, end.turn, end.tilt}));
    }
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    /// Many orders of magnitude, so that some lie near the pole.
    double tilt() { return kPi / 2 * std::exp(-uniform(0, 1) * uniform(0, 9)); }
    HeadAngles pose() { return {uniform(-3, 3), tilt()}; }

    void expect_on_circle(const OrientationArc& way, HeadAngles start, HeadAngles end) const {
        const Vector3d from = direction(start.turn, start.tilt);
        const Vector3d to = direction(end.turn, end.tilt);
        const Vector3d ahead = (to - from * from.dot(to)).normalized();
        for (int i = 0; i <= 50; ++i) {
            const double angle = way.length_rad() * i / 50;
            const HeadAngles at = way.at(angle).angles;
            const Vector3d wanted = std::cos(angle) * from + std::sin(angle) * ahead;
            ASSERT_LT((direction(at.turn, at.tilt) - wanted).norm(), kDirection)
                << start.turn << " " << start.tilt << " to " << end.turn << " " << end.tilt;
        }
    }

    const PlannerSetup setup = gantry_setup();
    const kinematics::TiltingHead head = setup.kinematics->tilting_head().value();
    std::mt19937 random{3};
};

TEST_F(OrientationArcs, DirectionGoesEvenlyAlongTheGreatCircleAndEndsAreExact) {
    int found = 0;
    for (int i = 0; i < 1000; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        HeadAngles start = pose();
        HeadAngles end = pose();
        start.tilt *= side;
        end.tilt *= side;
        const auto way = arc(start, end);
        ASSERT_EQ(way.has_value(), std::abs(end.turn - start.turn) < kPi);
        if (!way) continue;
        ++found;
        expect_on_circle(*way, start, end);
        EXPECT_NEAR(way->length_rad(),
                    std::acos(direction(start.turn, start.tilt).dot(direction(end.turn, end.tilt))), 1e-7);
        EXPECT_EQ(way->at(0).angles.turn, start.turn);
        EXPECT_EQ(way->at(0).angles.tilt, start.tilt);
        EXPECT_NEAR(way->at(way->length_rad()).angles.turn, end.turn, 1e-13);
        EXPECT_NEAR(way->at(way->length_rad()).angles.tilt, end.tilt, 1e-13);
    }
    EXPECT_GT(found, 500);
}

TEST_F(OrientationArcs, ShortWaysToo) {
    for (int i = 0; i < 500; ++i) {
        const HeadAngles start = pose();
        const double small = std::exp(-uniform(1, 14));
        const HeadAngles end{start.turn + small * uniform(-1, 1), start.tilt * (1 + small * uniform(-1, 1))};
        const auto way = arc(start, end);
        if (std::acos(std::min(1.0, direction(start.turn, start.tilt).dot(direction(end.turn, end.tilt)))) <
            1e-7)
            continue;
        ASSERT_TRUE(way) << static_cast<int>(way.error());
        expect_on_circle(*way, start, end);
    }
}

TEST_F(OrientationArcs, DerivativesAreTheSlopesOfTheValuesAndKeepTheirBounds) {
    for (int i = 0; i < 300; ++i) {
        const auto way = arc(pose(), {uniform(-1, 1), uniform(0.05, kPi / 2)});
        if (!way) continue;
        const HeadBounds bounds = way->bounds();
        const double h = way->length_rad() / 400;
        double first =
            std::max(std::abs(way->at(0).first.turn), std::abs(way->at(way->length_rad()).first.turn));
        const auto derivative = [&](double at, double HeadAngles::*joint, HeadAngles HeadState::*of) {
            return ((way->at(at + h).*of).*joint - (way->at(at - h).*of).*joint) / (2 * h);
        };
        for (int k = 1; k < 400; ++k) {
            const double at = k * h;
            const HeadState state = way->at(at);
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
TEST_F(OrientationArcs, TurnsFastestNearThePole) {
    const auto way = arc({-1, 0.4}, {1, 0.4});
    ASSERT_TRUE(way);
    const double nearest = std::atan(std::tan(0.4) * std::cos(1));  // of a right-angled triangle
    const HeadState middle = way->at(way->length_rad() / 2);
    EXPECT_NEAR(middle.angles.tilt, nearest, 1e-12);
    EXPECT_NEAR(middle.angles.turn, 0, 1e-12);
    EXPECT_NEAR(middle.first.turn, 1 / std::sin(nearest), 1e-12);
    EXPECT_NEAR(way->bounds().first.turn, 1 / std::sin(nearest), 1e-12);
    EXPECT_NEAR(way->tilt_range().min, nearest, 1e-12);
    EXPECT_NEAR(way->tilt_range().max, 0.4, 1e-12);
}

TEST_F(OrientationArcs, TiltRangeIsThatOfDenseInstants) {
    for (int i = 0; i < 300; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        HeadAngles start{uniform(-1.5, 1.5), side * uniform(0.05, 3)};
        HeadAngles end{uniform(-1.5, 1.5), side * uniform(0.05, 3)};
        const auto way = arc(start, end);
        ASSERT_TRUE(way);
        const Range range = way->tilt_range();
        double least = start.tilt;
        double most = start.tilt;
        for (int k = 0; k <= 2000; ++k) {
            const double tilt = way->at(way->length_rad() * k / 2000).angles.tilt;
            least = std::min(least, tilt);
            most = std::max(most, tilt);
        }
        EXPECT_LE(range.min, least + 1e-12);
        EXPECT_GE(range.max, most - 1e-12);
        EXPECT_NEAR(range.min, least, 1e-4);
        EXPECT_NEAR(range.max, most, 1e-4);
    }
}

TEST_F(OrientationArcs, ThroughThePoleTheTiltChangesItsSign) {
    const HeadAngles start{0.3, -0.5};
    const HeadAngles end{0.3, 0.8};
    const auto way = arc(start, end);
    ASSERT_TRUE(way);
    expect_on_circle(*way, start, end);
    EXPECT_NEAR(way->at(0.5).angles.tilt, 0, 1e-15);
    EXPECT_EQ(way->at(0.7).angles.turn, 0.3);
    EXPECT_EQ(way->bounds().first.turn, 0);
    EXPECT_EQ(way->bounds().first.tilt, 1);
}

TEST_F(OrientationArcs, PartsLieOnTheWhole) {
    const auto way = arc({-1.2, 0.9}, {1, 0.2});
    ASSERT_TRUE(way);
    const double from = way->length_rad() * 0.3;
    const OrientationArc part = way->part(from, way->length_rad() * 0.8).part(0.01, 0.2);
    EXPECT_NEAR(part.length_rad(), 0.19, 1e-15);
    for (const double at : {0.0, 0.1, 0.19}) {
        EXPECT_NEAR(part.at(at).angles.turn, way->at(from + 0.01 + at).angles.turn, 1e-15);
        EXPECT_NEAR(part.at(at).angles.tilt, way->at(from + 0.01 + at).angles.tilt, 1e-15);
    }
    EXPECT_LE(part.bounds().first.turn, way->bounds().first.turn);
}

TEST_F(OrientationArcs, WhatHasNoWaySaysWhy) {
    const auto why = [&](HeadAngles start, HeadAngles end) {
        const auto way = arc(start, end);
        EXPECT_FALSE(way);
        return way ? OrientationFault{} : way.error();
    };
    EXPECT_EQ(why({0, kPi / 2}, {kPi, kPi / 2}), OrientationFault::opposite);
    EXPECT_EQ(why({0, kPi / 2}, {0, -kPi / 2}), OrientationFault::opposite);
    EXPECT_EQ(why({0, 0.5}, {2 * kPi, 0.5}), OrientationFault::same) << "a whole turn";
    EXPECT_EQ(why({0, 0.5}, {kPi, -0.5}), OrientationFault::same) << "the other branch";
    EXPECT_EQ(why({0, 0}, {1, 0.5}), OrientationFault::at_pole);
    EXPECT_EQ(why({0, 0.5}, {1, 0}), OrientationFault::at_pole);
    EXPECT_EQ(why({0, 0.5}, {kPi, 0.4}), OrientationFault::other_end) << "through the pole";
    EXPECT_EQ(why({0, 0.5}, {0.2, -0.4}), OrientationFault::other_end) << "the other branch";
    EXPECT_EQ(why({0, 0.5}, {1 + 2 * kPi, 0.4}), OrientationFault::other_end) << "a whole turn more";
    EXPECT_TRUE(arc({0, 0}, {0, 0.5})) << "from the pole along a meridian";
}

}  // namespace
}  // namespace gsim::motion::orientation_arc_test
