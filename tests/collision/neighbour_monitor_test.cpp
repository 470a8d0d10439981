#include "collision/monitor/neighbour_monitor.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "tests/collision/random_motion.h"

namespace gsim::cell::neighbour_watch_test {
namespace {

using Eigen::Vector3d;

/// A gantry with a ball at the end of its tool, and its bodies.
struct Gantry {
    explicit Gantry(const std::string& tables) : cell(read(tables)) {
        bodies = std::make_shared<const MachineBodies>(machine_bodies(cell, machine::make_kinematics(af5())));
    }
    static Cell read(const std::string& tables) {
        auto cell = read_cell("[cell]\nname = \"test\"\n" + tables, "cell.toml", af5());
        EXPECT_TRUE(cell) << (cell ? "" : cell.error().message);
        return *std::move(cell);
    }

    Cell cell;
    std::shared_ptr<const MachineBodies> bodies;
};

std::string ball(double diameter_mm) {
    return fmt::format("[[shape]]\nname = \"ball\"\non = \"tool\"\nshape = {{ sphere_mm = {} }}\n",
                       diameter_mm);
}

rrs::CartPos shifted(double x, double y = 0, double z = 0) {
    rrs::CartPos pose = rrs::CartPos::Identity();
    pose.translation() = Vector3d(x, y, z);
    return pose;
}

/// Two of them, the world of the second so far along X and Y from that of the first.
struct Neighbours {
    Neighbours(const std::string& first_tables, const std::string& second_tables, double x, double y = 0)
        : first(first_tables), second(second_tables), monitor(shifted(0), shifted(x, y)) {
        monitor.set_bodies(first.bodies, second.bodies);
    }
    void on_segment(double start_s, double duration_s, const motion::Segment& first_segment,
                    const motion::Segment& second_segment, bool process_on = false) {
        monitor.on_segment(start_s, duration_s, {first_segment, start_s - first_segment.start_s, process_on},
                           {second_segment, start_s - second_segment.start_s, false});
    }
    const std::vector<Contact>& contacts() const { return monitor.contacts(); }

    Gantry first;
    Gantry second;
    NeighbourMonitor monitor;
};

// Both ramp up and then go on at their speeds: x = v (t - v / 2a).
TEST(NeighbourMonitor, SlidesMeetWhenTheirTravelsAddUp) {
    Neighbours robots(ball(30), ball(50), 100);
    const auto to_right = line(0, joints(0, 500, 0), joints(1000, 500, 0), {200, 400});
    const auto to_left = line(0.25, joints(900, 500, 0), joints(100, 500, 0), {100, 1000});
    robots.on_segment(0, 0.25, to_right, standstill(0, joints(900, 500, 0), 0.25));
    robots.on_segment(0.25, 4, to_right, to_left);
    ASSERT_EQ(robots.contacts().size(), 1U);
    const double t_s = (1000 - 15 - 25 + 200 * 0.25 + 100 * (0.25 + 0.05)) / (200 + 100);
    EXPECT_NEAR(robots.contacts()[0].t_s, t_s, 2e-8);
    const Vector3d at(200 * (t_s - 0.25) + 15, 500, 0);
    EXPECT_TRUE(robots.contacts()[0].point_mm.isApprox(at, 1e-6))
        << robots.contacts()[0].point_mm.transpose();
    EXPECT_TRUE(robots.contacts()[0].penetrating);
    EXPECT_EQ(robots.monitor.pair_count(), 1U);
}

TEST(NeighbourMonitor, SmallStepsFindSameContactAsOneMove) {
    Neighbours robots(ball(30), ball(50), 100);
    const auto stand = standstill(0, joints(900, 500, 0), 10);
    for (int step = 0; step < 4000; ++step) {
        const auto small =
            line(step * 1e-3, joints(0.25 * step, 500, 0), joints(0.25 * (step + 1), 500, 0), {250});
        robots.on_segment(small.start_s, small.duration_s, small, stand);
    }
    ASSERT_EQ(robots.contacts().size(), 1U);
    EXPECT_NEAR(robots.contacts()[0].t_s, (1000.0 - 15 - 25) / 250, 2e-8);
}

// Balls that cross at a right angle, at the same distance from the crossing: they come nearest there.
TEST(NeighbourMonitor, CrossingBodiesMeetOnlyBelowContactDistance) {
    for (const double late_mm : {56.0, 57.0}) {
        Neighbours robots(ball(30), ball(50), 0.0, 300);
        const auto along_x = line(0, joints(0, 500, 0), joints(1000, 500, 0), {100});
        const auto along_y = line(0, joints(500, -300 - late_mm, 0), joints(500, 700 - late_mm, 0), {100});
        robots.on_segment(0, 10, along_x, along_y);
        // Seen from each other they move along the diagonal, off by sqrt(1/2) of one's delay.
        const bool meet = late_mm * std::sqrt(0.5) < 15 + 25;
        EXPECT_EQ(robots.contacts().size(), meet ? 1U : 0U) << late_mm;
        if (!meet || robots.contacts().empty()) continue;
        // (500 - 100 t)^2 + (500 + late - 100 t)^2 = 40^2
        const double t_s = (500 + late_mm / 2 - std::sqrt(2 * 40.0 * 40 - late_mm * late_mm) / 2) / 100;
        EXPECT_NEAR(robots.contacts()[0].t_s, t_s, 1e-6);
    }
}

TEST(NeighbourMonitor, ReportsRenewedContactAgain) {
    Neighbours robots(ball(30), ball(50), 100);
    const auto stand = standstill(0, joints(400, 500, 0), 100);
    double time_s = 0;
    for (const auto& [from, to] : {std::pair(0.0, 470.0), {470.0, 200.0}, {200.0, 470.0}}) {
        const auto move = line(time_s, joints(from, 500, 0), joints(to, 500, 0), {100});
        robots.on_segment(time_s, move.duration_s, move, stand);
        time_s += move.duration_s;
    }
    ASSERT_EQ(robots.contacts().size(), 2U);
    EXPECT_NEAR(robots.contacts()[0].t_s, 4.6, 2e-8);
    EXPECT_NEAR(robots.contacts()[1].t_s, 4.7 + 2.7 + 2.6, 2e-8);
}

TEST(NeighbourMonitor, JetTouchesOnlyWhileOn) {
    const std::string jet =
        "[[shape]]\nname = \"jet\"\non = \"jet\"\nshape = { box_mm = [1.0, 1.0, 200.0] }\n"
        "frame = { z_mm = -100.0 }\n";
    for (const bool on : {false, true}) {
        Neighbours robots(jet, ball(50), 0);
        // The tool points down: the jet's end is 200 mm below it, at the ball.
        const auto over = line(0, joints(0, 500, 200), joints(1000, 500, 200), {100});
        robots.on_segment(0, 2, over, standstill(0, joints(500, 500, 0), 10), false);
        robots.on_segment(2, 8, over, standstill(0, joints(500, 500, 0), 10), on);
        EXPECT_EQ(robots.contacts().size(), on ? 1U : 0U);
    }
}

TEST(NeighbourMonitor, ChecksCarriedBodiesButNotStationaryOnes) {
    const auto part = [](const std::string& on) {
        return fmt::format(
            "[[object]]\nname = \"part\"\nattached_to = \"{}\"\nshape = {{ box_mm = [10.0, 10.0, 10.0] }}\n",
            on);
    };
    EXPECT_EQ(Neighbours(part("tool"), ball(50), 0).monitor.pair_count(), 1U);
    EXPECT_EQ(Neighbours(part("world"), ball(50), 0).monitor.pair_count(), 0U);
    EXPECT_EQ(Neighbours(ball(10) + part("tool"), ball(50) + part("X"), 0).monitor.pair_count(), 4U);
}

/// A chain of six joints with a ball on its last link.
std::shared_ptr<const MachineBodies> random_machine(std::mt19937& random, const Shape& shape) {
    const int tool_joints = static_cast<int>(random() % 7);
    MachineBodies machine{
        std::make_shared<const kinematics::ChainKinematics>(random_chain(random, tool_joints)), {}};
    for (const int link : {tool_joints, 6}) {
        std::vector<int> to = joints_to(*machine.kinematics, link);
        std::reverse(to.begin(), to.end());
        machine.bodies.push_back(
            {machine.bodies.size(), Role::machine, {&shape, link, random_pose(random, 20)}, std::move(to)});
    }
    return std::make_shared<const MachineBodies>(std::move(machine));
}

/// The smallest distance of the balls at one time.
double distance_mm(const std::array<std::shared_ptr<const MachineBodies>, 2>& machines,
                   const std::array<rrs::CartPos, 2>& worlds, const std::array<rrs::JointPos, 2>& at,
                   double radius_mm) {
    std::array<std::vector<Vector3d>, 2> middles;
    for (std::size_t i = 0; i < 2; ++i) {
        const LinkFrames links = link_frames(*machines[i]->kinematics, at[i]);
        for (const CarriedBody& of : machines[i]->bodies)
            middles[i].push_back(worlds[i] * (of.body.pose_in_world(links) * Vector3d::Zero()));
    }
    double min_mm = 1e9;
    for (const Vector3d& a : middles[0]) {
        for (const Vector3d& b : middles[1]) min_mm = std::min(min_mm, (a - b).norm() - 2 * radius_mm);
    }
    return min_mm;
}

// For any motion of the joints no contact is missed, and the machines touch if one is reported.
TEST(NeighbourMonitor, FindsFirstContactOfRandomMachines) {
    std::mt19937 random(19);
    const double radius_mm = 10;
    const Shape shape = Shape::sphere(2 * radius_mm);
    int met = 0;
    for (int run = 0; run < 1500; ++run) {
        const std::array machines{random_machine(random, shape), random_machine(random, shape)};
        const std::array worlds{random_pose(random, 60), random_pose(random, 60)};
        const std::array starts{random_start(random), random_start(random)};
        const std::array segments{random_segment(random, starts[0], 3), random_segment(random, starts[1], 3)};
        const double end_s = std::min(segments[0].duration_s, segments[1].duration_s);
        const auto separation_mm = [&](double t_s) {
            return distance_mm(machines, worlds, {segments[0].position_at(t_s), segments[1].position_at(t_s)},
                               radius_mm);
        };
        if (separation_mm(0) < 0) continue;
        NeighbourMonitor monitor(worlds[0], worlds[1]);
        monitor.set_bodies(machines[0], machines[1]);
        constexpr int kPieces = 10;
        for (int part_index = 0; part_index < kPieces; ++part_index) {
            const double from_s = end_s * part_index / kPieces;
            monitor.on_segment(from_s, end_s / kPieces, {segments[0], from_s, false},
                               {segments[1], from_s, false});
        }
        double first_s = end_s;
        for (const Contact& contact : monitor.contacts()) first_s = std::min(first_s, contact.t_s);
        constexpr int kLooks = 200;
        for (int sample = 0; sample < kLooks; ++sample) {
            const double t_s = first_s * sample / kLooks;
            EXPECT_GT(separation_mm(t_s), -1e-6) << run << " at " << t_s << " of " << first_s;
        }
        if (monitor.contacts().empty()) continue;
        ++met;
        EXPECT_LT(separation_mm(first_s), 1e-5) << run;
    }
    EXPECT_GT(met, 10);
}

}  // namespace
}  // namespace gsim::cell::neighbour_watch_test
