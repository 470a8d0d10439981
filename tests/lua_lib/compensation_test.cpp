// Cutter compensation in both dialects: the tool's path next to a contour, the errors, and that the tool
// never comes nearer to the contour than its radius. Every point is worked out by hand; those of rs274ngc are
// also what LinuxCNC 2.9 prints for the same blocks.

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::compensation_test {
namespace {

constexpr double kPi = std::numbers::pi;

// Tools of diameter 4, 10 and 0 in the table of the 9/Series.
Conditions ab9_conditions() {
    Conditions setup = ngc_conditions();
    setup.options.dialect = "ab9";
    setup.options.data.tools[1] = {.length_mm = 0, .diameter_mm = 4};
    setup.options.data.tools[2] = {.length_mm = 0, .diameter_mm = 10};
    setup.options.data.tools[3] = {.length_mm = 0, .diameter_mm = 0};
    return setup;
}

Outcome run_ab9(const std::string& gcode) {
    return run(gcode, ab9_conditions());
}

// The moves as "r 1 2" (rapid), "f 1 2" (feed), "cw 1 2" and "ccw 1 2" to these two axes.
std::string ways(const Outcome& run, char first = 'X', char second = 'Y') {
    using enum simulation::MoveKind;
    std::string text;
    for (std::size_t n = 0; n < run.moves.size(); ++n) {
        const simulation::MoveKind kind = run.moves[n].info.kind;
        const std::string_view name = kind == rapid    ? "r"
                                      : kind == linear ? "f"
                                      : kind == arc_cw ? "cw"
                                                       : "ccw";
        const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4 + 0.0; };
        text += fmt::format("{}{} {:g} {:g}", text.empty() ? "" : ", ", name, rounded(run.to(n, first)),
                            rounded(run.to(n, second)));
    }
    return run.completed() ? text : text + "; " + run.message();
}

// --- RS274/NGC ---

const std::string kStart = "G21 F1000\nG0 X0 Y0 Z5\n";

TEST(NgcCompensation, EntersNextToFirstEndAndLeavesToProgrammedPoint) {
    EXPECT_EQ(ways(run_ngc(kStart + "G41.1 D4\nG1 X10\nX30\nG40\nG1 X40\n")),
              "r 0 0, f 10 2, f 30 2, f 40 0");
    EXPECT_EQ(ways(run_ngc(kStart + "G42.1 D4\nG1 X10\nX30\nG40\nG1 X40\n")),
              "r 0 0, f 10 -2, f 30 -2, f 40 0");
}

TEST(NgcCompensation, UsesRadiusOfToolDOrLoadedTool) {
    EXPECT_EQ(ways(run_ngc(kStart + "G41 D2\nG1 X10\nX30\n")), "r 0 0, f 10 2, f 30 2");
    EXPECT_EQ(ways(run_ngc(kStart + "T1 M6\nG41\nG1 X10\nX30\n")), "r 0 0, f 10 3, f 30 3");
    EXPECT_EQ(ways(run_ngc(kStart + "G41\nG1 X10\nX30\n")), "r 0 0, f 10 0, f 30 0");
    expect_alarm(run_ngc(kStart + "G41 D77\n"), 3, {"D77"});
    expect_alarm(run_ngc(kStart + "G41 D1.5\n"), 3, {"[compensation]", "G41: D", "integer", "1.5"});
}

TEST(NgcCompensation, NegativeDiameterSwapsSides) {
    EXPECT_EQ(ways(run_ngc(kStart + "G41.1 D-4\nG1 X10\nX30\n")), "r 0 0, f 10 -2, f 30 -2");
}

TEST(NgcCompensation, RoundsOutsideCornerByArc) {
    const Outcome r = run_ngc(kStart + "G41.1 D4\nG1 X10\nX30\nY-20\n");
    EXPECT_EQ(ways(r), "r 0 0, f 10 2, f 30 2, cw 32 0, f 32 -20");
    EXPECT_NEAR(r.moves.at(3).arc->center[0], 30, 1e-9);
    EXPECT_NEAR(r.moves.at(3).length_mm, kPi, 1e-9);
    EXPECT_EQ(r.moves.at(3).info.location.line, 6U);
}

TEST(NgcCompensation, ShortensMoveBeforeInsideCorner) {
    EXPECT_EQ(ways(run_ngc(kStart + "G41.1 D4\nG1 X10\nX30\nY20\n")), "r 0 0, f 10 2, f 28 2, f 28 20");
    // Into and out of an arc of radius 10 about (30, 10) with the tool inside, radius 8: the paths meet
    // tangentially.
    EXPECT_EQ(ways(run_ngc(kStart + "G41.1 D4\nG1 X10\nX30\nG3 X40 Y10 J10\nG1 Y30\n")),
              "r 0 0, f 10 2, f 30 2, ccw 38 10, f 38 30");
}

TEST(NgcCompensation, MovesOutsidePlaneKeepTheirOrder) {
    const Outcome r = run_ngc(kStart + "G41.1 D4\nG1 X10\nX30\nZ-5\nM8\nY20\n");
    EXPECT_EQ(ways(r), "r 0 0, f 10 2, f 28 2, f 28 2, f 28 20");
    EXPECT_EQ(r.to(2, 'Z'), 5);
    EXPECT_EQ(r.to(3, 'Z'), -5);
    EXPECT_EQ(r.moves.at(3).info.location.line, 6U);
}

// LinuxCNC has forgotten there that the tool came on an arc; the numbers are LinuxCNC's.
TEST(NgcCompensation, MoveOutsidePlaneAfterStopHidesPreviousArc) {
    const Outcome r = run_ngc(
        "G21 F384.1\nG0 X0 Y0\nG41.1 D3.175\nG1 X24.42 Y7.5\nG91\nG2 X19.8534 Y44.0310 R91.770\nM0\n"
        "G1 Z-2.420\nG1 X-33.0005 Y14.8798\nG90\nG40\nG1 X-70 Y70\nM2\n");
    EXPECT_EQ(ways(r),
              "f 23.0129 8.7285, cw 43.0489 52.5414, f 41.7261 50.9382, f 10.6204 64.9636, f -70 70");
}

TEST(NgcCompensation, EntryArcStaysTangentAtItsEnd) {
    const Outcome r = run_ngc(kStart + "G41.1 D2\nG3 X10 Y10 J10\nG1 Y30\n");
    EXPECT_EQ(ways(r), "r 0 0, ccw 9 10, f 9 30");
    const double centre = 9 - (81.0 + 100.0) / 18;  // as far from (0, 0) as from (9, 10), at Y10
    EXPECT_NEAR(r.moves.at(1).arc->center[0], centre, 1e-9);
    EXPECT_NEAR(r.moves.at(1).arc->center[1], 10, 1e-9);
}

TEST(NgcCompensation, WorksInLathePlane) {
    // Plane ZX: to the left of the path along +Z is +X.
    EXPECT_EQ(ways(run_ngc("G21 F1000 G18\nG0 X0 Z0 Y5\nG41.1 D4\nG1 Z10\nZ30\nX20\n"), 'Z', 'X'),
              "r 0 0, f 10 2, f 28 2, f 28 20");
    // Orientation 2 puts the tool's zero point a radius below the middle of its edge in X and Z.
    EXPECT_EQ(ways(run_ngc("G21 F1000 G18\nG0 X0 Z0 Y5\nG41.1 D4 L2\nG1 Z10\nZ30\n"), 'Z', 'X'),
              "r 0 0, f 8 0, f 28 0");
    expect_alarm(run_ngc("G19\nG41.1 D4\n"), 2, {"G19"});
    expect_alarm(run_ngc("G41.1 D4 L2\n"), 1, {"G18"});
}

TEST(NgcCompensation, InverseTimeSetsSpeedOnProgrammedPath) {
    const Outcome r = run_ngc(kStart + "G41.1 D4\nG93 G1 X10 F2\nX30 F2\nY20 F3\n");
    EXPECT_NEAR(r.moves.at(1).info.feed_per_min, 20, 1e-9);
    EXPECT_NEAR(r.moves.at(2).info.feed_per_min, 40, 1e-9);
    EXPECT_NEAR(r.moves.at(3).info.feed_per_min, 60, 1e-9);
}

TEST(NgcCompensation, RejectsImpossibleToolPath) {
    const std::string on = kStart + "G41.1 D4\n";
    expect_alarm(run_ngc(on + "G1 X2\n"), 4, {"entry move", "length of 2 mm"});
    expect_alarm(run_ngc(on + "G1 Z-1\n"), 4, {"entry move", "length of 0 mm"});
    expect_alarm(run_ngc(on + "G3 X1 Y1 J1\n"), 4, {"entry arc"});
    expect_alarm(run_ngc(on + "G1 X10\nG3 X10 Y2 J1\n"), 5, {"radius 1 mm", "larger than the tool"});
    // A step of 1 mm between two inside corners cannot be reached.
    expect_alarm(run_ngc(on + "G1 X10\nX30\nY1\nX10\n"), 7, {"inside corner", "gouging"});
    expect_alarm(run_ngc(on + "G1 X10\nX30\nG40\nG2 X40 Y10 I10\n"), 7, {"straight"});
}

TEST(NgcCompensation, RejectsWordsLeavingPath) {
    const std::string on = kStart + "G41.1 D4\nG1 X10\n";
    for (const char* word :
         {"G28", "G53 G0 X0", "G18", "G55", "G92 X0", "G41.1 D2", "G81 Z-1 R1", "M6", "G49"}) {
        const Outcome r = run_ngc(on + word + "\n");
        EXPECT_EQ(r.report.status, simulation::RunStatus::alarm) << word;
        EXPECT_NE(r.message().find("G40"), std::string::npos) << word << ": " << r.message();
    }
    EXPECT_TRUE(run_ngc(on + "G17\nG4 P0.1\nM3 S100\nG91 X10\n").completed());
}

// --- 9/Series ---

const std::string kLeft = "F1000 G0 X-20 Y-20\nG41 D1 G1 X0 Y0\n";

TEST(Ab9Compensation, EntersNextToSecondStartAndLeavesFromLastEnd) {
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nG40 X60 Y10\n")), "r -20 -20, f 0 2, f 50 2, f 60 10");
    EXPECT_EQ(ways(run_ab9("F1000 G0 X-20\nD1\nG42\nM8\nG1 X0\nX50\nG40\nX60 Y10\n")),
              "r -20 0, f 0 -2, f 50 -2, f 60 10");
    EXPECT_EQ(ways(run_ab9(kLeft + "G2 X20 Y-20 J-20\n")), "r -20 -20, f 0 2, cw 22 -20");
    expect_alarm(run_ab9("F1000 G0 X-20\nG41 D1\nG2 X0 I10\n"), 3, {"entry move", "straight"});
    expect_alarm(run_ab9(kLeft + "X50\nG40 G2 X60 Y10 J10\n"), 4, {"straight"});
}

TEST(Ab9Compensation, RequiresToolNumber) {
    expect_alarm(run_ab9("F1000 G0 X-20\nG41\nG1 X0\n"), 3, {"D"});
    expect_alarm(run_ab9("F1000 G0 X-20\nG41 D9 G1 X0\n"), 2, {"D9"});
    EXPECT_EQ(ways(run_ab9("F1000 G0 X-20\nG41 D0 G1 X0\nX50\n")), "r -20 0, f 0 0, f 50 0");
}

TEST(Ab9Compensation, PathsIntersectAtOutsideCornersUpToRightAngle) {
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nY-50\nG40 X60\n")), "r -20 -20, f 0 2, f 52 2, f 52 -50, f 60 -50");
    const double c = 2 * std::tan(kPi / 8);
    const Outcome r = run_ab9(kLeft + "X50\nX80 Y-30\nG40 X90\n");
    EXPECT_NEAR(r.to(2, 'X'), 50 + c, 1e-9);
    EXPECT_NEAR(r.to(2, 'Y'), 2, 1e-9);
}

TEST(Ab9Compensation, SharpOutsideCornerGetsLineOrArc) {
    // The path turns back by 180 degrees.
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nX0\nG40 X-10\n")),
              "r -20 -20, f 0 2, f 52 2, f 52 -2, f 0 -2, f -10 0");
    const Outcome r = run_ab9("G39.1\n" + kLeft + "X50\nX0\nG40 X-10\n");
    EXPECT_EQ(ways(r), "r -20 -20, f 0 2, f 50 2, cw 50 -2, f 0 -2, f -10 0");
    EXPECT_NEAR(r.moves.at(3).length_mm, 2 * kPi, 1e-9);
}

TEST(Ab9Compensation, InsideCornerIsPathIntersection) {
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nY50\nG40 X40\n")), "r -20 -20, f 0 2, f 48 2, f 48 50, f 40 50");
    expect_alarm(run_ab9(kLeft + "X50\nY1\nX0\n"), 5, {"backwards"});
    expect_alarm(run_ab9(kLeft + "X50\nG3 Y2 J1\n"), 4, {"radius 1 mm", "larger than the tool"});
}

TEST(Ab9Compensation, FullCircleStaysFullCircle) {
    const Outcome r = run_ab9(kLeft + "X50\nG3 J20\nG1 X80\nG40 X90\n");
    EXPECT_EQ(ways(r), "r -20 -20, f 0 2, f 50 2, ccw 50 2, f 80 2, f 90 0");
    EXPECT_NEAR(r.moves.at(3).length_mm, 2 * kPi * 18, 1e-6);
}

TEST(Ab9Compensation, AcceptsSideChangeWhileActive) {
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nG42 X80\nG40 X90\n")),
              "r -20 -20, f 0 2, f 50 2, f 50 -2, f 80 -2, f 90 0");
}

TEST(Ab9Compensation, AcceptsRadiusChangeWhileActive) {
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nD2 X80\nX99\nG40 X110\n")),
              "r -20 -20, f 0 2, f 50 2, f 80 5, f 99 5, f 110 0");
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nD2 G2 X70 Y-20 J-20\nG40 G1 Y-40\n")),
              "r -20 -20, f 0 2, f 50 2, f 50 5, cw 75 -20, f 70 -40");
}

TEST(Ab9Compensation, LooksAheadPastBlocksWithoutPlaneMove) {
    const Outcome r = run_ab9(kLeft + "X50\nZ-5\nM8\nG4 P0.1\nY50\nG40 X40\n");
    EXPECT_EQ(r.to(2, 'X'), 48);
    EXPECT_EQ(r.to(3, 'X'), 48);
    EXPECT_EQ(r.to(3, 'Z'), -5);
    std::string far = kLeft + "X50\n";
    for (int i = 1; i <= 21; ++i) far += fmt::format("Z{}\n", -i);
    const Outcome too_far = run_ab9(far + "Y50\nG40 X40\n");
    EXPECT_EQ(too_far.to(2, 'X'), 50);
    EXPECT_FALSE(too_far.report.messages.warnings.empty());
}

TEST(Ab9Compensation, MirrorImageSwapsSides) {
    EXPECT_EQ(ways(run_ab9("F1000\nG51.1 X0\nG0 X20\nG42 D1 G1 X0\nX-10\nY10\nG40 X20\n")),
              "r -20 0, f 0 2, f 8 2, f 8 10, f -20 10");
}

TEST(Ab9Compensation, CoordinateChangeLeadsOutAndInAgain) {
    EXPECT_EQ(ways(run_ab9(kLeft + "X50\nX60\nG92 X0 Y0\nG1 X10\nX30\nG40 X40\n")),
              "r -20 -20, f 0 2, f 50 2, f 60 0, f 70 2, f 90 2, f 100 0");
    expect_alarm(run_ab9(kLeft + "X50\nG18\n"), 4, {"plane"});
}

// --- The tool never touches the path ---

struct PathElement {
    std::array<double, 2> from{}, to{}, centre{};
    double radius = 0, sweep = 0;  // of an arc
    int turn = 0;                  // 1 counterclockwise, -1 clockwise, 0: a line
};

double distance(const PathElement& path_element, std::array<double, 2> p) {
    const auto to_point = [&](std::array<double, 2> q) { return std::hypot(p[0] - q[0], p[1] - q[1]); };
    const double nearest_end = std::min(to_point(path_element.from), to_point(path_element.to));
    if (path_element.turn == 0) {
        const double dx = path_element.to[0] - path_element.from[0],
                     dy = path_element.to[1] - path_element.from[1];
        const double t =
            ((p[0] - path_element.from[0]) * dx + (p[1] - path_element.from[1]) * dy) / (dx * dx + dy * dy);
        if (t <= 0 || t >= 1) return nearest_end;
        return std::abs((p[1] - path_element.from[1]) * dx - (p[0] - path_element.from[0]) * dy) /
               std::hypot(dx, dy);
    }
    const double start = std::atan2(path_element.from[1] - path_element.centre[1],
                                    path_element.from[0] - path_element.centre[0]);
    const double angle = std::atan2(p[1] - path_element.centre[1], p[0] - path_element.centre[0]);
    const double along = std::remainder(path_element.turn * (angle - start) - kPi, 2 * kPi) + kPi;
    return along <= path_element.sweep ? std::abs(to_point(path_element.centre) - path_element.radius)
                                       : nearest_end;
}

// A path that always leads on in X, of lines and arcs, some tangent to the one before.
std::vector<PathElement> random_path(std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    std::vector<PathElement> path;
    std::array<double, 2> at{0, 0};
    double heading = between(-1.2, 1.2);
    const int count = std::uniform_int_distribution(2, 8)(random);
    for (int i = 0; i < count; ++i) {
        if (between(0, 1) > 0.3) heading = between(-1.45, 1.45);
        PathElement path_element;
        path_element.from = at;
        if (between(0, 1) < 0.5) {
            const double length = between(0.5, 20);
            path_element.to = {at[0] + length * std::cos(heading), at[1] + length * std::sin(heading)};
        } else {
            double target = between(-1.45, 1.45);
            if (std::abs(target - heading) < 0.1) target = heading > 0 ? heading - 0.5 : heading + 0.5;
            path_element.turn = target > heading ? 1 : -1;
            path_element.sweep = std::abs(target - heading);
            path_element.radius = between(0.5, 20);
            const double r = path_element.turn * path_element.radius;
            path_element.centre = {at[0] - r * std::sin(heading), at[1] + r * std::cos(heading)};
            path_element.to = {path_element.centre[0] + r * std::sin(target),
                               path_element.centre[1] - r * std::cos(target)};
            heading = target;
        }
        at = path_element.to;
        path.push_back(path_element);
    }
    return path;
}

std::string words(const PathElement& path_element) {
    if (path_element.turn == 0)
        return fmt::format("G1{{x={:.17g}, y={:.17g}}}\n", path_element.to[0], path_element.to[1]);
    return fmt::format("G{}{{x={:.17g}, y={:.17g}, i={:.17g}, j={:.17g}}}\n", path_element.turn > 0 ? 3 : 2,
                       path_element.to[0], path_element.to[1], path_element.centre[0] - path_element.from[0],
                       path_element.centre[1] - path_element.from[1]);
}

TEST(Ab9Compensation, KeepsToolRadiusFromRandomPaths) {
    int completed = 0;
    for (unsigned seed = 1; seed <= 150; ++seed) {
        std::mt19937 random(seed);
        const std::vector<PathElement> path = random_path(random);
        const bool left = random() % 2 == 0;
        Conditions setup = ab9_conditions();
        const double radius = 0.25 * static_cast<double>(1 + random() % 8);
        setup.options.data.tools[1].diameter_mm = 2 * radius;
        std::string lua =
            fmt::format("F(1000) G0{{x=-30, y={}}} {}() {}{{d=1}} G1{{x=0, y=0}}\n", left ? 40 : -40,
                        random() % 2 == 0 ? "G39" : "G39_1", left ? "G41" : "G42");
        for (const PathElement& path_element : path) lua += words(path_element);
        const Outcome r = run_lua(lua + "G40()\n", setup);
        if (!r.completed()) {
            EXPECT_NE(r.message().find("compensation"), std::string::npos)
                << seed << ": " << r.message() << lua;
            continue;
        }
        ++completed;
        // The entry move comes from the side of the tool; the following moves are the tool's path along the
        // contour.
        for (std::size_t n = 2; n < r.segments.size(); ++n) {
            const motion::Segment& segment = r.segments[n];
            for (int i = 0; i <= 10; ++i) {
                const auto position = segment.position_at(segment.duration_s * i / 10);
                const std::array<double, 2> point{position[0], position[1]};
                double nearest = 1e9;
                for (const PathElement& path_element : path)
                    nearest = std::min(nearest, distance(path_element, point));
                ASSERT_GT(nearest, radius - 1e-5) << "seed " << seed << ", move " << n << "\n" << lua;
                ASSERT_LT(nearest, radius * std::numbers::sqrt2 + 1e-5)
                    << "seed " << seed << ", move " << n << "\n"
                    << lua;
            }
        }
    }
    EXPECT_GT(completed, 50);
}

}  // namespace
}  // namespace gsim::script::compensation_test
