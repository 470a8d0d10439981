// Machines with a TCP off the axes that turn it: the TCP keeps to its lines and arcs while it turns.
#include "toolpath/rotary/axis_moves.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "toolpath/rotary/merged_lines.h"

namespace gsim::path::axis_moves_test {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance_mm = 0.02;
constexpr double kDigit_mm = 0.001;

machine::Machine offset_head() {
    return machine::load_machine(tests::source_path("samples/machines/gantry-offset-head.toml")).value();
}

struct Log : MoveSink {
    std::vector<AxisMove> moves;
    std::vector<std::string> notes, actions;
    void move(const AxisMove& move) override { moves.push_back(move); }
    void dwell(double) override {}
    void acceleration(double) override {}
    void action(const std::string& name) override { actions.push_back(name); }
    void call(const SubPath&) override {}
    void note(const TargetId&, std::string_view message) override { notes.emplace_back(message); }
};

/// The moves of one path of a program.
struct Moved {
    machine::Machine machine;
    Log log;
    std::string error;

    Moved(const machine::Machine& of, const Program& program, std::size_t path) : machine(of) {
        const MachineSpace space = MachineSpace::make(machine).value();
        EXPECT_TRUE(space.is_coupled());
        const States states(program);
        const auto turns = plan_rotary(program, space, states, {});
        EXPECT_TRUE(turns) << turns.error().message;
        if (!turns) return;
        const auto done =
            AxisMoves(program, space, states, *turns, {kTolerance_mm, kDigit_mm}).run(path, log);
        if (!done) error = done.error().message;
    }
    explicit Moved(std::vector<Target> targets)
        : Moved(offset_head(), {"n", {{"root", std::move(targets)}}, 0}, 0) {}

    Vector3d tcp(const AxisValues& axes) const {
        rrs::JointPos joints(axes.size());
        for (Eigen::Index i = 0; i < axes.size(); ++i) {
            joints[i] = machine::joint_value(machine.axes[static_cast<std::size_t>(i)], axes[i]);
        }
        return machine::make_kinematics(machine)->forward(joints).translation();
    }
    /// Returns the TCP in the middle of linear move `n`.
    Vector3d middle(std::size_t n) const { return tcp((log.moves[n - 1].axes + log.moves[n].axes) / 2); }
    /// The time that the feeds of the moves from `n` on make, min.
    double minutes_from(std::size_t n) const {
        double minutes = 0;
        for (std::size_t i = n; i < log.moves.size(); ++i) {
            const AxisValues displacement = log.moves[i].axes - log.moves[i - 1].axes;
            const double linear_mm = displacement.head(3).norm();
            const bool rotary = linear_mm < kDigit_mm / 2;
            EXPECT_EQ(log.moves[i].feed_is_rotary, rotary);
            minutes += (rotary ? displacement.tail(2).norm() : linear_mm) / log.moves[i].feed_per_min;
        }
        return minutes;
    }
};

Point to(const Vector& position, double a, double c) {
    Point point;
    point.position_mm = position;
    point.orientation = RotaryAxes{{'A', a}, {'C', c}};
    point.feed_mm_min = 1000;
    return point;
}

TEST(AxisMoves, KeepsTcpOnLineWhileRotaryAxesMove) {
    const Moved run({to({900, 800, 300}, 0, 10), to({1000, 800, 300}, 40, 75)});
    ASSERT_GT(run.log.moves.size(), 5U);
    EXPECT_EQ(run.log.notes.size(), 1U);
    for (std::size_t i = 1; i < run.log.moves.size(); ++i) {
        for (const Vector3d& tcp : {run.tcp(run.log.moves[i].axes), run.middle(i)}) {
            EXPECT_LT(std::hypot(tcp.y() - 800, tcp.z() - 300), 1.5 * kTolerance_mm) << i;
        }
        EXPECT_FALSE(run.log.moves[i].arc);
    }
    EXPECT_LT((run.tcp(run.log.moves.back().axes) - Vector3d(1000, 800, 300)).norm(), 1e-9);
    EXPECT_NEAR(run.minutes_from(1), 100.0 / 1000, 1e-3) << "the feed is of the tip";
}

TEST(AxisMoves, SplitsArcOnlyIfHeadTurns) {
    Point arc = to({900, 800, 300}, 30, 20);
    arc.motion = MotionType::circular;
    arc.arc = CenterArc{{950, 800, 300}, {0, 0, 1}, 360};
    const Moved still({to({900, 800, 300}, 30, 20), arc});
    ASSERT_EQ(still.log.moves.size(), 2U);
    ASSERT_TRUE(still.log.moves[1].arc);
    EXPECT_NEAR(still.log.moves[1].arc->center_offset_mm[0], 50, 1e-9);

    arc.orientation = RotaryAxes{{'A', 30}, {'C', 100}};
    const Moved turning({to({900, 800, 300}, 30, 20), arc});
    EXPECT_GT(turning.log.moves.size(), 20U);
    for (std::size_t i = 1; i < turning.log.moves.size(); ++i) {
        const Vector3d tcp = turning.middle(i);
        EXPECT_NEAR(std::hypot(tcp.x() - 950, tcp.y() - 800), 50, 1.5 * kTolerance_mm) << i;
        EXPECT_NEAR(tcp.z(), 300, 1.5 * kTolerance_mm);
    }
}

// A half circle with ends tilted in opposite directions has two paths between them, of which the axes take
// the shorter one.
TEST(AxisMoves, ReportsTiltThroughVertical) {
    const auto leaning = [](const Vector& at, double x, double y) {
        Point point = to(at, 0, 0);
        point.orientation = ToolAxis{{x, y, 1}};
        return point;
    };
    Point half = leaning({1000, 800, 300}, -0.5, 0);
    half.motion = MotionType::circular;
    half.arc = CenterArc{{950, 800, 300}, {0, 0, 1}, 180};
    const Moved over({leaning({900, 800, 300}, 0.5, 0), half});
    EXPECT_TRUE(std::any_of(over.log.notes.begin(), over.log.notes.end(), [](const std::string& note) {
        return note.find("is vertical between them") != std::string::npos;
    }));

    std::vector<Target> targets{leaning({900, 800, 300}, 0.5, 0)};
    for (const double turn_deg : {45, 90, 135, 180}) {
        const double angle = (180 + turn_deg) * kRadPerDeg;
        Point part = leaning({950 + 50 * std::cos(angle), 800 + 50 * std::sin(angle), 300},
                             -0.5 * std::cos(angle), -0.5 * std::sin(angle));
        part.motion = MotionType::circular;
        part.arc = CenterArc{{950, 800, 300}, {0, 0, 1}, 45};
        targets.emplace_back(part);
    }
    const Moved along(std::move(targets));
    EXPECT_EQ(along.error, "");
    for (const std::string& note : along.log.notes)
        EXPECT_EQ(note.find("is vertical"), std::string::npos) << note;
    for (std::size_t i = 1; i < along.log.moves.size(); ++i) {
        const AxisValues middle = (along.log.moves[i - 1].axes + along.log.moves[i].axes) / 2;
        const Vector3d axis = MachineSpace::make(along.machine).value().tool_axis(middle);
        EXPECT_NEAR(std::hypot(axis.x(), axis.y()) / axis.z(), 0.5, 1e-3) << "on the cone";
    }
}

// The TCP stays in the work while the head turns about it: X, Y and Z move, so F is in mm/min.
TEST(AxisMoves, KeepsTcpWhileTurningAboutIt) {
    Point turn = to({900, 800, 300}, 40, 60);
    turn.feed_deg_min = 2000;
    const Moved run({to({900, 800, 300}, 0, 0), turn});
    ASSERT_GT(run.log.moves.size(), 5U);
    for (std::size_t i = 1; i < run.log.moves.size(); ++i) {
        EXPECT_LT((run.middle(i) - Vector3d(900, 800, 300)).norm(), 1.5 * kTolerance_mm);
    }
    EXPECT_NEAR(run.minutes_from(1), std::hypot(40, 60) / 2000, 1e-4);
}

// Full turns return X, Y and Z to their positions; between them the TCP must not swing.
TEST(AxisMoves, KeepsTcpWhileUnwinding) {
    std::vector<Target> targets;
    for (int i = 0; i <= 30; ++i) targets.emplace_back(to({900.0 + i, 800, 300}, 20, 30 * i));
    std::get<Point>(targets[0]).actions = {"waterjet_on"};
    const Moved run(std::move(targets));
    ASSERT_EQ(run.error, "");
    std::size_t unwinding = 0;
    for (std::size_t i = 1; i < run.log.moves.size(); ++i) {
        if (!run.log.moves[i].rapid) continue;
        ++unwinding;
        EXPECT_LT((run.middle(i) - run.tcp(run.log.moves[i].axes)).norm(), 1.5 * kTolerance_mm) << i;
    }
    EXPECT_GT(unwinding, 20U);
    EXPECT_EQ(run.log.actions.size() % 2, 1U) << "off and on again";
    EXPECT_GE(run.log.actions.size(), 3U);
}

TEST(AxisMoves, ReportsOutOfReachBetweenPoints) {
    // Both ends are within X; between them, at C 180, its axis is 60 mm further than at C 0.
    const Moved run({to({2950, 800, 300}, 0, 100), to({2950, 800, 300}, 0, 260)});
    EXPECT_NE(run.error.find("out of reach: X"), std::string::npos) << run.error;
}

Program with_sub_path(const Point& first_use, const Point& second_use, const Point& begin) {
    return {"n",
            {{"root", {first_use, SubPath{1, 1}, second_use, SubPath{1, 1}}},
             {"sub", {begin, to({1000, 900, 300}, 10, 60)}}},
            0};
}

TEST(AxisMoves, SubPathsConsiderTheirEntryPositions) {
    const Point begin = to({1000, 800, 300}, 30, 20);
    const Point near = to({900, 800, 300}, 0, 0);
    const Moved same(offset_head(), with_sub_path(near, near, begin), 1);
    EXPECT_GT(same.log.moves.size(), 5U);
    EXPECT_EQ(same.log.notes.size(), 2U) << "two lines with turning axes";
    EXPECT_LT(std::hypot(same.middle(1).y() - 800, same.middle(1).z() - 300), 1.5 * kTolerance_mm);

    const Moved other(offset_head(), with_sub_path(near, to({900, 800, 300}, 0, 40), begin), 1);
    ASSERT_EQ(other.log.notes.size(), 2U);
    EXPECT_NE(other.log.notes[0].find("may leave the line"), std::string::npos);

    const Point turned_before = to({900, 800, 300}, 30, 20);
    const Point elsewhere = to({900, 850, 300}, 30, 20);
    const Moved still(offset_head(), with_sub_path(turned_before, elsewhere, begin), 1);
    EXPECT_EQ(still.log.notes.size(), 1U) << "the head comes turned already";
}

// Only the last of several points on one line of the axes is left; other points bend the path, turn no axis,
// or have other feeds.
TEST(AxisMoves, MergesCollinearLines) {
    const machine::Machine machine = offset_head();
    const MachineSpace space = MachineSpace::make(machine).value();
    Log log;
    MergedLines merged(log, space, {kTolerance_mm, kDigit_mm});
    const auto line = [&merged](double x, double c, double feed) {
        AxisMove move;
        move.axes = AxisValues::Zero(5);
        move.axes[0] = x;
        move.axes[3] = c;
        move.feed_per_min = feed;
        merged.move(move);
    };
    for (int i = 0; i <= 10; ++i) line(i, 2 * i, 500);
    for (int i = 11; i <= 20; ++i) line(i, 20 + 0.1 * i * i, 500);
    line(21, 62, 600);
    line(22, 64, 600);
    merged.action("waterjet_on");
    line(23, 66, 600);
    line(24, 66, 600);
    line(25, 66, 600);
    merged.finish();
    std::vector<double> ends;
    for (const AxisMove& move : log.moves) ends.push_back(move.axes[0]);
    EXPECT_EQ(ends, (std::vector<double>{0, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 22, 23, 24, 25}));
}

// The program's digits say no more of them than lines do.
TEST(AxisMoves, ApproximatesTinyArcsWithinDigits) {
    Point arc = to({900.02, 800, 300}, 0, 0);
    arc.motion = MotionType::circular;
    arc.arc = CenterArc{{900.01, 800, 300}, {0, 0, 1}, 180};
    const Moved run({to({900, 800, 300}, 0, 0), arc});
    EXPECT_TRUE(run.log.notes.empty());
    for (std::size_t i = 1; i < run.log.moves.size(); ++i) {
        const Vector3d tcp = run.middle(i);
        EXPECT_NEAR(std::hypot(tcp.x() - 900.01, tcp.y() - 800), 0.01, kDigit_mm / 2);
    }
}

}  // namespace
}  // namespace gsim::path::axis_moves_test
