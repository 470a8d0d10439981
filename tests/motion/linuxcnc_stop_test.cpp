// StopMotion and ContinueMotion with the planner of LinuxCNC: corners that are rounded by blend arcs, or by
// two motions at once.

#include "tests/motion/linuxcnc_run.h"
#include "tests/motion/motion_checks.h"

namespace gsim::motion {
namespace {

using rrs::Status;

constexpr double kOffWay_mm = 1e-5;

PlannerSetup linuxcnc_setup() {
    PlannerSetup setup = fast_machine();
    const kinematics::DhLink slide{.kind = rrs::JointKind::prismatic};
    const kinematics::DhLink turn{.kind = rrs::JointKind::revolute};
    setup.kinematics = std::make_shared<kinematics::ChainKinematics>(kinematics::DhChain(
        rrs::CartPos::Identity(), std::vector{slide, slide, slide, turn, turn}, rrs::CartPos::Identity()));
    setup.controller.planner = rrs::PlannerKind::linuxcnc;
    setup.controller.servo_period_s = 0.001;
    setup.queue_capacity = 2000;
    return setup;
}

struct Step {
    Status status;
    rrs::JointPos joints;
    double elapsed_s;
};

Step step(DefaultPlanner& planner) {
    Step step{};
    rrs::CartPos pose;
    step.status = planner.GetNextStep(step.joints, pose, step.elapsed_s);
    return step;
}

/// Steps until the robot stands; where.
rrs::JointPos run_out(DefaultPlanner& planner) {
    for (int i = 0; i < 1'000'000; ++i) {
        const Step now = step(planner);
        if (now.status == Status::RRS_NEED_MORE_DATA) return now.joints;
    }
    throw std::runtime_error("it does not come to an end");
}

/// A plan as a way to keep to.
class Way {
  public:
    explicit Way(const std::vector<Segment>& plan)
        : plan_(plan), greatest_acceleration_(acceleration_of(plan)) {
        for (const Segment& segment : plan) {
            for (int k = 0; k <= kSamples; ++k)
                points_.push_back(segment.position_at(segment.duration_s * k / kSamples));
        }
    }

    /// The greatest of each joint.
    static rrs::JointPos acceleration_of(const std::vector<Segment>& segments) {
        rrs::JointPos greatest = rrs::JointPos::Zero(segments.front().start.size());
        for (const Segment& segment : segments) {
            for (int i = 0; i < 40; ++i) {
                const JointState state = segment.at(segment.duration_s * (i + 0.5) / 40);
                greatest = greatest.cwiseMax(state.acceleration.cwiseAbs());
            }
        }
        return greatest;
    }
    const rrs::JointPos& greatest_acceleration() const { return greatest_acceleration_; }

    /// How far off the way a point is. Looks closely at the segments that can come nearest.
    double distance_to(const rrs::JointPos& point) const {
        double least = kUnlimited;
        for (const Sample& sample : nearest_samples(point)) {
            if (sample.least_distance > least) break;
            least = std::min(least, distance_near(sample, point));
        }
        return least;
    }

  private:
    static constexpr int kSamples = 12;
    struct Sample {
        const Segment* segment;
        int number;
        double distance;
        double least_distance;  ///< Of the segment.
    };

    /// Of each segment, in the order of their least distances.
    std::vector<Sample> nearest_samples(const rrs::JointPos& point) const {
        std::vector<Sample> samples;
        for (std::size_t i = 0; i < plan_.size(); ++i) {
            const std::span<const rrs::JointPos> points(&points_[i * (kSamples + 1)], kSamples + 1);
            Sample nearest{&plan_[i], 0, kUnlimited, 0};
            double spacing = 0;
            for (int k = 0; k <= kSamples; ++k) {
                const rrs::JointPos& at = points[static_cast<std::size_t>(k)];
                if (k > 0) spacing = std::max(spacing, (at - points[static_cast<std::size_t>(k - 1)]).norm());
                if (const double distance = (at - point).norm(); distance < nearest.distance)
                    nearest = {&plan_[i], k, distance, 0};
            }
            nearest.least_distance = nearest.distance - spacing;
            samples.push_back(nearest);
        }
        std::sort(samples.begin(), samples.end(),
                  [](const Sample& a, const Sample& b) { return a.least_distance < b.least_distance; });
        return samples;
    }
    static double distance_near(const Sample& sample, const rrs::JointPos& point) {
        const double step_s = sample.segment->duration_s / kSamples;
        const auto distance = [&](double t_s) { return (sample.segment->position_at(t_s) - point).norm(); };
        double low = step_s * std::max(sample.number - 1, 0);
        double high = step_s * std::min(sample.number + 1, kSamples);
        for (int i = 0; i < 50; ++i) {
            const double third = (high - low) / 3;
            if (distance(low + third) < distance(high - third))
                high -= third;
            else
                low += third;
        }
        return distance((low + high) / 2);
    }

    const std::vector<Segment>& plan_;
    rrs::JointPos greatest_acceleration_;
    std::vector<rrs::JointPos> points_;
};

/// Positions join, and all velocities.
void expect_smooth_joins(const std::vector<Segment>& segments, double speed_step) {
    for (std::size_t i = 1; i < segments.size(); ++i) {
        const Segment& before = segments[i - 1];
        const Segment& segment = segments[i];
        ASSERT_NEAR(segment.start_s, before.end_s(), 1e-9);
        ASSERT_LT((segment.start - before.end_position()).cwiseAbs().maxCoeff(), 1e-8) << i;
        const JointState from = before.at(before.duration_s);
        const JointState to = segment.at(0);
        ASSERT_LT((to.velocity - from.velocity).cwiseAbs().maxCoeff(), speed_step) << i;
    }
}

struct Program {
    std::vector<rrs::JointPos> targets;
    double tolerance_mm = 0;
    double speed_mm_s = 100;
    bool arcs = false;  ///< Half a circle behind each target, 6 mm along X.

    rrs::JointPos end() const { return arcs ? behind_arc(targets.back()) : targets.back(); }
    static rrs::JointPos behind_arc(const rrs::JointPos& target) {
        return target + 6 * rrs::JointPos::Unit(target.size(), 0);
    }
};

Program random_program(std::mt19937& random, bool turns) {
    std::uniform_real_distribution<double> place(-30, 30), angle(-0.5, 0.5);
    Program program;
    const int count = std::uniform_int_distribution<int>(3, 14)(random);
    const double size = std::bernoulli_distribution(0.3)(random) ? 0.1 : 1;
    for (int i = 0; i < count; ++i) {
        rrs::JointPos target = rrs::JointPos::Zero(5);
        for (int joint = 0; joint < 3; ++joint) target[joint] = size * place(random);
        if (turns) target[3] = angle(random);
        program.targets.push_back(target);
    }
    if (std::bernoulli_distribution(0.5)(random)) program.tolerance_mm = 0.5;
    program.arcs = std::bernoulli_distribution(0.3)(random);
    program.speed_mm_s = std::uniform_real_distribution<double>(10, 200)(random);
    return program;
}

void put(const Program& program, ReadyPlanner& ready) {
    ready.planner.SelectMotionType(rrs::MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(program.speed_mm_s);
    ready.planner.SetPathMode(rrs::PathMode::continuous, program.tolerance_mm, 0);
    for (const rrs::JointPos& target : program.targets) {
        ASSERT_EQ(ready.to(target), Status::RRS_SUCCESS) << ready.message();
        if (!program.arcs) continue;
        const Eigen::Vector3d center = target.head<3>() + Eigen::Vector3d(3, 0, 0);
        ASSERT_EQ(ready.arc_to(Program::behind_arc(target), center, Eigen::Vector3d::UnitZ(), kPi),
                  Status::RRS_SUCCESS);
    }
}

std::vector<Segment> planned(const Program& program, const PlannerSetup& setup) {
    ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
    put(program, ready);
    ready.planner.flush();
    return ready.collector.segments;
}

/// Stops three times at random instants and goes on; what is moved then is on the planned way.
void stop_and_go(std::mt19937& random, const Program& program, const PlannerSetup& setup, int& blends) {
    const std::vector<Segment> plan = planned(program, setup);
    const Way way(plan);
    ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
    DefaultPlanner& planner = ready.planner;
    put(program, ready);
    planner.SetInterpolationTime(std::max(plan.back().end_s() / 200, 0.0005));
    for (int stops = 0; stops < 3; ++stops) {
        const int steps = std::uniform_int_distribution<int>(0, 120)(random);
        for (int i = 0; i < steps; ++i) step(planner);
        ASSERT_EQ(planner.StopMotion(), Status::RRS_SUCCESS);
        const rrs::JointPos stands = run_out(planner);
        ASSERT_EQ(step(planner).joints, stands);
        ASSERT_EQ(planner.ContinueMotion(), Status::RRS_SUCCESS);
    }
    ASSERT_LT((run_out(planner) - program.end()).norm(), 1e-9);

    const std::vector<Segment>& segments = ready.collector.segments;
    double planned_step = 1e-5;  // of speeds: what the model itself has
    for (std::size_t i = 1; i < plan.size(); ++i) {
        const rrs::JointPos jump = plan[i].at(0).velocity - plan[i - 1].at(plan[i - 1].duration_s).velocity;
        planned_step = std::max(planned_step, jump.cwiseAbs().maxCoeff() * (1 + 1e-6) + 1e-5);
    }
    ASSERT_NO_FATAL_FAILURE(expect_smooth_joins(segments, planned_step));
    const rrs::JointPos most = Way::acceleration_of(segments);
    for (int joint = 0; joint < 5; ++joint) {
        const double limit = std::max(setup.joints[static_cast<std::size_t>(joint)].max_acceleration,
                                      way.greatest_acceleration()[joint]);
        ASSERT_LE(most[joint], limit * 1.01) << "joint " << joint;
    }
    for (const Segment& segment : segments) {
        blends += segment.beside != nullptr;
        for (const double share : {0.27, 0.61}) {
            const rrs::JointPos at = segment.position_at(segment.duration_s * share);
            ASSERT_LT(way.distance_to(at), kOffWay_mm) << segment.start_s;
        }
    }
}

TEST(LinuxcncStop, KeepsWayAndLimitsAtAnyInstant) {
    std::mt19937 random(31);
    int blends = 0;
    for (int round = 0; round < 60; ++round) {
        const Program program = random_program(random, round % 3 != 0);
        stop_and_go(random, program, linuxcnc_setup(), blends);
        if (testing::Test::HasFatalFailure()) FAIL() << "round " << round;
    }
    EXPECT_GT(blends, 300);
}

/// 100 mm along X, then along Y, round the corner as far as it comes: both moves have half of the
/// acceleration there, and the other half brakes.
TEST(LinuxcncStop, InABlendItStandsAtOnce) {
    PlannerSetup setup = linuxcnc_setup();
    ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
    put({.targets = {joint_pos({100, 0, 0, 0.1, 0}), joint_pos({100, 100, 0, 0.2, 0})}}, ready);
    ready.planner.SetInterpolationTime(0.001);
    double speed = 0;
    rrs::JointPos before = rrs::JointPos::Zero(5);
    for (rrs::JointPos at = before; at[1] < 1; before = std::exchange(at, step(ready.planner).joints))
        speed = (at - before).norm() / 0.001;
    ASSERT_EQ(ready.planner.StopMotion(), Status::RRS_SUCCESS);
    ready.planner.SetInterpolationTime(10);
    const Step stopped = step(ready.planner);
    EXPECT_LT(stopped.elapsed_s, 2 * speed / 245);
    EXPECT_LT(stopped.joints[1], 50);
    EXPECT_LT(stopped.joints[0], 100);
    EXPECT_EQ(ready.planner.CancelMotion(), Status::RRS_SUCCESS);
    ASSERT_EQ(ready.to(rrs::JointPos::Zero(5)), Status::RRS_SUCCESS) << ready.message();
    EXPECT_EQ(run_out(ready.planner), rrs::JointPos::Zero(5));
    expect_smooth_joins(ready.collector.segments, 1e-5);
}

}  // namespace
}  // namespace gsim::motion
