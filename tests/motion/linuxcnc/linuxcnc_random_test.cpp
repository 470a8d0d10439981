// Random programs of lines and arcs in all modes, on real and odd machines.

#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "tests/motion/linuxcnc/linuxcnc_run.h"

namespace gsim::motion::linuxcnc_random_test {
namespace {

class Programs {
  public:
    explicit Programs(unsigned seed) : random_(seed) {}

    double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
    bool chance(double share) { return std::bernoulli_distribution(share)(random_); }

    void step(LinuxcncRun& run) {
        if (chance(0.1)) change_rules(run.next);
        run.next.rapid = chance(0.05);
        const double size = std::pow(10, 1.5 * number());
        rrs::JointPos joints = run.next.start;
        if (chance(0.3) && !run.next.rapid) {
            const int x = run.setup.position_joints[0], y = run.setup.position_joints[1];
            ASSERT_TRUE(run.arc(joints[x] + size * number(), joints[y] + size * number(), 4 * number()));
            return;
        }
        const bool turns = chance(0.1);
        for (int joint = 0; joint < run.setup.joint_count(); ++joint) {
            const bool leads = run.setup.role(joint) == JointRole::position;
            if (leads ? chance(0.7) : turns) joints[joint] += (leads ? size : 0.1) * number();
        }
        ASSERT_TRUE(run.go(joints));
    }

  private:
    void change_rules(PathMove& move) {
        constexpr rrs::PathMode kModes[] = {rrs::PathMode::exact_stop, rrs::PathMode::exact_path,
                                            rrs::PathMode::continuous, rrs::PathMode::continuous};
        move.mode = kModes[std::uniform_int_distribution<>(0, 3)(random_)];
        move.tolerance_mm = chance(0.5) ? 0 : std::pow(10, 1.5 * number() - 1);
        move.merge_tolerance_mm = chance(0.7) ? 0 : move.tolerance_mm;
        move.rules.programmed_speed_mm_s = 50 * std::pow(10, number());
        move.rules.max_path_speed_mm_s = chance(0.5) ? 60 : kUnlimited;
    }

    std::mt19937 random_;
};

// The tool's speed has no jump that its axes could not make within a period; at a stop it has none at all.
void expect_no_jumps(const LinuxcncRun& run) {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    for (const Segment& segment : run.segments) {
        const Eigen::Vector3d start = segment.at(0).velocity.head<3>();
        ASSERT_LT((start - velocity).cwiseAbs().maxCoeff(), 490.3 * 1e-3) << "target " << segment.target_id;
        velocity = segment.at(segment.duration_s).velocity.head<3>();
    }
    ASSERT_LT(velocity.norm(), 1e-6);
}

void expect_speed(const LinuxcncRun& run, double path_mm_s) {
    for (const Segment& segment : run.segments) {
        if (segment.superimposed) continue;  // two motions add up
        for (int i = 0; i <= 4; ++i) {
            ASSERT_LE(segment.path_speed_mm_s(segment.duration_s * i / 4), path_mm_s * (1 + 1e-6));
        }
    }
}

TEST(LinuxcncRandom, SegmentsJoinWithoutJump) {
    Programs programs(41);
    for (int i = 0; i < 60; ++i) {
        LinuxcncRun run(fast_machine(), i % 5 == 0 ? 0 : 1e-3);
        for (int k = 0; k < 150; ++k) {
            ASSERT_NO_FATAL_FAILURE(programs.step(run)) << "program " << i;
            if (programs.chance(0.01)) run.end();
        }
        EXPECT_TRUE(std::isfinite(run.end()));
        ASSERT_NO_FATAL_FAILURE(expect_chain(run)) << "program " << i;
        ASSERT_NO_FATAL_FAILURE(expect_no_jumps(run)) << "program " << i;
    }
}

void use_2_10(PlannerSetup& setup, bool curves, double jerk) {
    setup.controller.linuxcnc.release = rrs::LinuxcncRelease::v2_10;
    setup.controller.ramps.limit_jerk = curves;
    setup.path.max_jerk_mm_s3 = jerk;
    for (JointSetup& joint : setup.joints) joint.max_jerk = jerk;
}

TEST(LinuxcncRandom, SegmentsOfRelease210Join) {
    std::mt19937 random(46);
    Programs programs(47);
    for (int i = 0; i < 60; ++i) {
        PlannerSetup setup = i % 2 == 0 ? fast_machine() : odd_setup(random);
        use_2_10(setup, i % 4 >= 2, std::pow(10, 5 + 3 * programs.number()));
        LinuxcncRun run(setup, i % 5 == 0 ? 0 : 1e-3);
        for (int k = 0; k < 150; ++k) ASSERT_NO_FATAL_FAILURE(programs.step(run)) << "program " << i;
        EXPECT_TRUE(std::isfinite(run.end()));
        ASSERT_NO_FATAL_FAILURE(expect_chain(run)) << "program " << i;
    }
}

TEST(LinuxcncRandom, SCurvesJoinWithoutJump) {
    Programs programs(48);
    for (int i = 0; i < 30; ++i) {
        PlannerSetup setup = fast_machine();
        use_2_10(setup, true, std::pow(10, 4 + programs.number()));
        LinuxcncRun run(setup);
        for (int k = 0; k < 150; ++k) ASSERT_NO_FATAL_FAILURE(programs.step(run)) << "program " << i;
        run.end();
        ASSERT_NO_FATAL_FAILURE(expect_no_jumps(run)) << "program " << i;
    }
}

/// A move that ends before the preceding move comes to a standstill, because that move turns a slow joint.
/// The remainder of that move runs to the end of the short one.
TEST(LinuxcncRandom, ReachesEachTargetOnceIfShortMoveEndsFirst) {
    std::mt19937 random(45);
    std::uniform_real_distribution<double> unit(0, 1);
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    for (int i = 0; i < 300; ++i) {
        run.next.tolerance_mm = i % 2 == 0 ? 0 : unit(random);
        for (const bool turns : {true, false}) {
            const double length = turns ? 0.02 + 3 * unit(random) : std::exp(-7 - 3 * unit(random));
            const double angle = 2 * kPi * unit(random);
            rrs::JointPos joints = run.next.start;
            joints.head<2>() += length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            if (turns) joints[3] += unit(random) - 0.5;
            ASSERT_TRUE(run.go(joints));
        }
        run.end();
    }
    ASSERT_NO_FATAL_FAILURE(expect_chain(run));
    std::vector<rrs::TargetId> reached;
    for (const Segment& segment : run.segments) {
        if (segment.reaches_target) reached.push_back(segment.target_id);
    }
    ASSERT_EQ(std::adjacent_find(reached.begin(), reached.end(), std::greater_equal<>()), reached.end())
        << "each once";
    EXPECT_EQ(reached.back(), run.last_id);
}

TEST(LinuxcncRandom, KeepsProgrammedSpeed) {
    std::mt19937 random(44);
    std::uniform_real_distribution<double> number(-20, 20);
    for (int i = 0; i < 30; ++i) {
        LinuxcncRun run(fast_machine());
        run.next.mode = i % 3 == 0 ? rrs::PathMode::exact_path : rrs::PathMode::continuous;
        run.next.tolerance_mm = i % 3 == 1 ? 0 : 0.3;
        run.next.rules.programmed_speed_mm_s = 30;
        run.next.rules.max_path_speed_mm_s = i % 2 == 0 ? 25 : 40;
        for (int k = 0; k < 100; ++k) {
            const double x = run.next.start[0] + number(random), y = run.next.start[1] + number(random);
            ASSERT_TRUE(k % 3 == 0 ? run.arc(x, y, number(random) / 10) : run.line(x, y));
        }
        run.end();
        ASSERT_NO_FATAL_FAILURE(expect_speed(run, i % 2 == 0 ? 25 : 30)) << "program " << i;
    }
}

TEST(LinuxcncRandom, PlansMachinesWithAnyJoints) {
    std::mt19937 random(42);
    Programs programs(43);
    for (int i = 0; i < 30; ++i) {
        LinuxcncRun run(odd_setup(random));
        for (int k = 0; k < 150; ++k) ASSERT_NO_FATAL_FAILURE(programs.step(run)) << "program " << i;
        EXPECT_TRUE(std::isfinite(run.end()));
        ASSERT_NO_FATAL_FAILURE(expect_chain(run)) << "program " << i;
    }
}

// Emitted segments do not depend on when the remainder follows: a run equals its own beginning.
TEST(LinuxcncRandom, EmittedSegmentsAreFinal) {
    for (unsigned seed = 50; seed < 60; ++seed) {
        Programs one(seed), other(seed);
        LinuxcncRun first(fast_machine()), second(fast_machine());
        for (int k = 0; k < 100; ++k) ASSERT_NO_FATAL_FAILURE(one.step(first));
        const std::size_t out = first.segments.size();
        for (int k = 0; k < 200; ++k) ASSERT_NO_FATAL_FAILURE(other.step(second));
        second.end();
        ASSERT_LE(out, second.segments.size());
        for (std::size_t k = 0; k < out; ++k) {
            ASSERT_EQ(first.segments[k].duration_s, second.segments[k].duration_s);
            ASSERT_EQ(first.segments[k].end, second.segments[k].end);
        }
    }
}

// A program twice as large with twice the speeds and accelerations takes the same time.
TEST(LinuxcncRandom, ScaledProgramTakesSameTime) {
    for (unsigned seed = 70; seed < 80; ++seed) {
        PlannerSetup larger = fast_machine();
        for (std::size_t joint = 0; joint < 3; ++joint) {
            larger.joints[joint].max_speed *= 2;
            larger.joints[joint].max_acceleration *= 2;
        }
        LinuxcncRun one(fast_machine(), 0), two(larger, 0);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-50, 50);
        one.next.mode = two.next.mode = rrs::PathMode::continuous;
        one.next.tolerance_mm = 0.1;
        two.next.tolerance_mm = 0.2;
        two.next.rules.programmed_speed_mm_s *= 2;
        for (int k = 0; k < 100; ++k) {
            const double x = number(random), y = number(random);
            ASSERT_TRUE(one.line(x, y));
            ASSERT_TRUE(two.line(2 * x, 2 * y));
        }
        ASSERT_NEAR(one.end(), two.end(), 1e-9 * one.end_s);
    }
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_random_test
