// Arcs in planes that a rotation turns out of the main ones, and arcs through a point: their position in the
// machine follows from the turn of the plane's normal and of the centre.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/lua_lib/ngc_run.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::oblique_arcs_test {
namespace {

using Eigen::Vector3d;
using simulation::MoveKind;
using simulation::RecordedMove;

constexpr double kPi = std::numbers::pi;
constexpr double kTiny_mm = 1e-6;

Vector3d turned(const Vector3d& vector, double degrees, const Vector3d& about) {
    return Eigen::AngleAxisd(degrees * kPi / 180, about) * vector;
}

Vector3d arc_axis(const RecordedMove& move) {
    return move.info.kind == MoveKind::arc_ccw ? move.info.normal : Vector3d(-move.info.normal);
}

struct Wanted {
    Vector3d center;  // any point of the axis
    Vector3d axis;    // about which the arc runs by the right hand
    Vector3d end;
    double sweep_rad = 0;
    double rise_mm = 0;
};

// Every point that the machine passes on its last move is at one distance from the axis, climbs in proportion
// to its angle, and the angle runs by the right hand.
void expect_helix(const Outcome& run, const Wanted& expected_value) {
    ASSERT_TRUE(run.completed()) << run.message() << run.lua;
    const RecordedMove& move = run.moves.back();
    EXPECT_LT((arc_axis(move) - expected_value.axis).norm(), 1e-9) << move.info.normal.transpose();
    const motion::Segment& segment = run.segments.back();
    const auto at = [&](double share) {
        return Vector3d(segment.position_at(share * segment.duration_s).head<3>());
    };
    EXPECT_LT((at(1) - expected_value.end).norm(), kTiny_mm) << at(1).transpose();
    const Vector3d start = at(0) - expected_value.center;
    const double along = start.dot(expected_value.axis);
    const Vector3d out = start - along * expected_value.axis;
    const Vector3d ahead = expected_value.axis.cross(out);
    double before = 0;
    for (int i = 1; i <= 64; ++i) {
        const Vector3d point = at(i / 64.0) - expected_value.center;
        const Vector3d lateral = point - point.dot(expected_value.axis) * expected_value.axis;
        EXPECT_NEAR(lateral.norm(), out.norm(), kTiny_mm) << i;
        double angle = std::atan2(lateral.dot(ahead), lateral.dot(out));
        while (angle < before - 1e-6) angle += 2 * kPi;
        EXPECT_LT(angle - before, kPi) << i;
        EXPECT_NEAR(point.dot(expected_value.axis) - along,
                    expected_value.rise_mm * angle / expected_value.sweep_rad, kTiny_mm)
            << i;
        before = angle;
    }
    EXPECT_NEAR(before, expected_value.sweep_rad, 1e-6);
    EXPECT_NEAR(move.length_mm, std::hypot(out.norm() * expected_value.sweep_rad, expected_value.rise_mm),
                kTiny_mm);
}

// Program coordinates of a system with the origin 10, 20, 5 that is turned about Z.
Vector3d placed(const Vector3d& point, double degrees) {
    return Vector3d(10, 20, 5) + turned(point, degrees, Vector3d::UnitZ());
}

const std::string kTurned30 = "G21 F1000 G10 L2 P1 X10 Y20 Z5 R30\nG0 X5 Y5 Z5\n";
const Vector3d kNormal30 = turned(Vector3d::UnitY(), 30, Vector3d::UnitZ());

TEST(ObliqueArcs, ZxArcFollowsRotationAboutZ) {
    const Wanted quarter{placed({15, 5, 5}, 30), kNormal30, placed({15, 5, 15}, 30), kPi / 2, 0};
    expect_helix(run_ngc(kTurned30 + "G18 G3 X15 Z15 I10 K0\n"), quarter);
    expect_helix(run_ngc(kTurned30 + "G18 G3 X15 Z15 R10\n"), quarter);
    expect_helix(run_ngc(kTurned30 + "G18 G90.1 G3 X15 Z15 I15 K5\n"), quarter);
    Wanted rest = quarter;
    rest.axis = -kNormal30;
    rest.sweep_rad = 1.5 * kPi;
    expect_helix(run_ngc(kTurned30 + "G18 G2 X15 Z15 I10 K0\n"), rest);
}

TEST(ObliqueArcs, HelixFollowsRotatedNormal) {
    expect_helix(run_ngc(kTurned30 + "G18 G3 X15 Y12 Z15 I10 K0 P2\n"),
                 {placed({15, 5, 5}, 30), kNormal30, placed({15, 12, 15}, 30), 2.5 * kPi, 7});
    const Vector3d normal = turned(Vector3d::UnitX(), 30, Vector3d::UnitZ());
    expect_helix(run_ngc(kTurned30 + "G19 G2 X-4 J10\n"),
                 {placed({5, 15, 5}, 30), -normal, placed({-4, 5, 5}, 30), 2 * kPi, 9});
}

TEST(ObliqueArcs, ReportMainPlaneAfterQuarterTurns) {
    for (const int degrees : {90, 180, 270}) {
        const std::string start =
            "G21 F1000 G10 L2 P1 X10 Y20 Z5 R" + std::to_string(degrees) + "\nG0 X5 Y5 Z5\n";
        const Vector3d normal = turned(Vector3d::UnitY(), degrees, Vector3d::UnitZ());
        const Outcome r = run_ngc(start + "G18 G3 X15 Z15 I10 K0\n");
        expect_helix(r, {placed({15, 5, 5}, degrees), normal, placed({15, 5, 15}, degrees), kPi / 2, 0});
        EXPECT_EQ(simulation::main_plane(r.moves.back().info.normal), degrees == 180 ? Plane::zx : Plane::yz);
    }
}

TEST(ObliqueArcs, XyArcFollowsRotationAboutX) {
    // G68 turns YZ about X by 40 degrees, or mirrors before it turns.
    const Vector3d x = Vector3d::UnitX();
    const auto location = [&](const Vector3d& point) { return turned(point, 40, x); };
    expect_helix(run("F1000 G19 G68 Y0 Z0 R40\nG0 X20 Y10 Z0\nG17 G3 X10 Y20 I-10\n"),
                 {location({10, 10, 0}), location(Vector3d::UnitZ()), location({10, 20, 0}), kPi / 2, 0});
    expect_helix(run("F1000 G19 G68 Y0 Z0 R40\nG0 X20 Y10 Z0\nG17 G3 I-10 AR=90\n"),
                 {location({10, 10, 0}), location(Vector3d::UnitZ()), location({10, 20, 0}), kPi / 2, 0});
    expect_helix(run("F1000 G51.1 X0\nG19 G68 Y0 Z0 R40\nG0 X-20 Y10 Z0\nG17 G3 X-30 Y20 I-10\n"),
                 {location({30, 10, 0}), location(-Vector3d::UnitZ()), location({30, 20, 0}), kPi / 2, 0});
    expect_helix(run("F1000 G14 P2\nG19 G68 Y0 Z0 R40\nG0 X10 Y5 Z0\nG17 G3 X5 Y10 R5\n"),
                 {location({10, 10, 0}), location(Vector3d::UnitZ()), location({10, 20, 0}), kPi / 2, 0});
}

TEST(ObliqueArcs, PassThroughIntermediatePoint) {
    // About (110,100,100), over a point as far to the side as it is up: the plane holds X and (0,1,1).
    const Outcome r =
        run("F1000 G0 X100 Y100 Z100\nCIP X120 I1=110 J1=107.0710678118655 K1=107.0710678118655\n");
    expect_helix(r, {{110, 100, 100}, Vector3d(0, 1, -1).normalized(), {120, 100, 100}, kPi, 0});
    EXPECT_EQ(simulation::main_plane(r.moves.back().info.normal), std::nullopt);
}

// The compensated tool in a rotated plane moves as it does without the rotation, and is rotated with it.
void expect_turned(const Outcome& plain, const Outcome& turned_run, const Eigen::Affine3d& map) {
    ASSERT_TRUE(plain.completed()) << plain.message() << plain.lua;
    ASSERT_TRUE(turned_run.completed()) << turned_run.message() << turned_run.lua;
    ASSERT_EQ(plain.moves.size(), turned_run.moves.size()) << plain.lua;
    for (std::size_t i = 1; i < plain.moves.size(); ++i) {  // the first one leads there
        const RecordedMove& expected_value = plain.moves[i];
        const RecordedMove& found = turned_run.moves[i];
        EXPECT_LT((map * expected_value.end.head<3>() - found.end.head<3>()).norm(), kTiny_mm) << i;
        EXPECT_NEAR(expected_value.length_mm, found.length_mm, kTiny_mm) << i;
        EXPECT_NEAR(expected_value.info.feed_per_min, found.info.feed_per_min, 1e-6) << i;
        ASSERT_EQ(expected_value.arc.has_value(), found.arc.has_value()) << i;
        if (!expected_value.arc) continue;
        EXPECT_LT((map.linear() * arc_axis(expected_value) - arc_axis(found)).norm(), 1e-9) << i;
        EXPECT_LT((map * expected_value.arc->center - found.arc->center).norm(), kTiny_mm) << i;
    }
}

TEST(ObliqueArcs, CompensatedPathRotatesWithPlane) {
    const std::string part =
        "G18 G0 X-20 Y3 Z-20\nG41.1 D6 G1 X0 Z0\nX30\nG2 X50 Z20 R20\nG3 X60 Z30 Y8 I10 K0\nG1 Z60\nX20 "
        "Z45\nX-5 "
        "Z70\nG40 X-30 Z70\nM2\n";
    for (const int degrees : {0, 30, 90, 181}) {
        const std::string head = "G21 F1000 G10 L2 P1 X10 Y20 Z5 R";
        Eigen::Affine3d map = Eigen::Translation3d(10, 20, 5) *
                              Eigen::AngleAxisd(degrees * kPi / 180, Vector3d::UnitZ()) *
                              Eigen::Translation3d(-10, -20, -5);
        expect_turned(run_ngc(head + "0\n" + part), run_ngc(head + std::to_string(degrees) + "\n" + part),
                      map);
    }
    // The 9/Series, in a plane that G68 turns about X.
    Conditions setup = ngc_conditions();
    setup.options.dialect = "ab9";
    const std::string square =
        "G17 G0 X0 Y0 Z10\nG41 D1 G1 X20 Y20 F1000\nX60\nG3 X80 Y40 I0 J20\nG1 Y80,R5\nX20,C4\nY20\nG40 X0 "
        "Y0\n"
        "M30\n";
    Eigen::Affine3d map(Eigen::AngleAxisd(kPi / 6, Vector3d::UnitX()));
    for (const char* corners : {"G39\n", "G39.1\n"})
        expect_turned(run(corners + square, setup),
                      run(std::string("G19 G68 Y0 Z0 R30\n") + corners + square, setup), map);
}

// A rotation belongs to its work coordinate system, and comes back with it.
TEST(ObliqueArcs, RejectsRotationOfCompensationPlane) {
    expect_alarm(run("G54 G19\nG68 Y0 Z0 R30\nG55 G17 G0 X0 Y0\nG41 D1 G1 X20 Y20 F1000\nX60\nG54\nX80\n",
                     with_tools()),
                 6,
                 {"a rotation that turns its plane is not possible while cutter compensation is on; program "
                  "G40 first"});
}

TEST(ObliqueArcs, RejectsEllipse) {
    expect_alarm(run("F1000 G14 I2\nG19 G68 Y0 Z0 R40\nG0 X20 Y10 Z0\nG17 G3 X10 Y20 I-10\n"), 4,
                 {"an arc becomes an ellipse if its two axes are scaled differently"});
}

}  // namespace
}  // namespace gsim::script::oblique_arcs_test
