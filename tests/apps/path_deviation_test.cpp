// Reported deviation of the TCP from the programmed path on the part, compared with the trajectory.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/run_program.h"

namespace gsim::apps::way_deviation_test {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using Points = std::vector<Vector3d>;

constexpr double kStep_s = 0.0005;

double to_line(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
    const Vector3d displacement = to - from;
    const double square = displacement.squaredNorm();
    const double share = square > 0 ? std::clamp((point - from).dot(displacement) / square, 0.0, 1.0) : 0.0;
    return (point - from - share * displacement).norm();
}

double to_lines(const Vector3d& point, const Points& lines) {
    double min = 1e300;
    for (std::size_t i = 1; i < lines.size(); ++i)
        min = std::min(min, to_line(point, lines[i - 1], lines[i]));
    return min;
}

// Returns the larger of both distances of one path from the other, for paths that nowhere come near
// themselves.
double apart(const Points& programmed, const Points& driven) {
    double max = 0;
    for (const Vector3d& point : driven) max = std::max(max, to_lines(point, programmed));
    for (const Vector3d& point : programmed) max = std::max(max, to_lines(point, driven));
    return max;
}

std::string axis(const char* letter, const std::string& rest) {
    return fmt::format("[[axis]]\nletter = \"{}\"\n{}\n", letter, rest);
}

std::string linear(const char* letter, const std::string& more = "") {
    return axis(letter, fmt::format("kind = \"linear\"\nmax_speed_mm_s = 500\nmax_acceleration_mm_s2 = 1000\n"
                                    "direction = \"{}\"\n{}",
                                    static_cast<char>(std::tolower(letter[0])), more));
}

std::string machine(const std::string& controller, const std::string& axes) {
    return fmt::format("[machine]\nname = \"m\"\ninverse = \"none\"\n[controller]\n{}\n{}", controller, axes);
}

const std::string kThreeSlides = linear("X") + linear("Y") + linear("Z");
// A table that turns about X carries the part; the tool is above its axis.
const std::string kWrap =
    linear("X") + linear("Y") + linear("Z") +
    axis("A",
         "kind = \"rotary\"\ncarries = \"work\"\nmax_speed_deg_s = 90\nmax_acceleration_deg_s2 = 400\n"
         "direction = \"x\"");

class PathDeviationMonitor : public Apps {
  protected:
    struct Run {
        json blends;
        Points driven;  // on the part
    };

    // Runs a program with columns of X, Y, Z and, if the machine has a table, A; the part turns about X.
    Run run(const std::string& machine_text, const std::string& program) {
        const std::string machine_file = write("m.toml", machine_text);
        const std::string file = write("part.ngc", program);
        const Ended ended =
            gsim_run({file, "--dialect", "rs274ngc", "--machine", machine_file, "--quiet", "--report",
                      "report.json", "--trajectory", "way.csv", "--step", fmt::format("{}", kStep_s)});
        EXPECT_EQ(ended.status, 0) << ended.err;
        return {text::parse_json<json>(read("report.json"))["blends"], points()};
    }

    Points points() {
        std::istringstream rows(read("way.csv"));
        std::string row;
        std::getline(rows, row);
        const bool turns = row.find("a_deg") != std::string::npos;
        Points points;
        while (std::getline(rows, row)) {
            std::replace(row.begin(), row.end(), ',', ' ');
            std::istringstream values(row);
            double t_s = 0, line = 0, a_deg = 0;
            Vector3d at;
            values >> t_s >> line >> at.x() >> at.y() >> at.z();
            if (turns) values >> a_deg;
            points.push_back(on_part(at, a_deg));
        }
        return points;
    }

    static Vector3d on_part(const Vector3d& at, double a_deg) {
        return Eigen::AngleAxisd(a_deg * std::numbers::pi / 180, Vector3d::UnitX()) * at;
    }
};

struct Zigzag {
    std::string program;
    Points points;
};

// Returns lines that turn by little, so that the path nowhere comes near itself.
Zigzag zigzag(unsigned seed, double length_mm, int lines) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> heading(-1.2, 1.2), share(0.3, 1.7);
    Zigzag outcome{"", {Vector3d::Zero()}};
    Vector3d at = Vector3d::Zero();
    for (int i = 0; i < lines; ++i) {
        const double angle = heading(random);
        const double step = length_mm * share(random);
        at += step * Vector3d(std::cos(angle), std::sin(angle), 0);
        at = (at * 1e4).array().round() / 1e4;
        outcome.points.push_back(at);
        outcome.program += fmt::format("G1 X{:.4f} Y{:.4f}\n", at.x(), at.y());
    }
    return outcome;
}

// G64 P merges lines, within its tolerance, and rounds the corners of the lines that come of it.
TEST_F(PathDeviationMonitor, MatchesTrajectoryForMergedLines) {
    double max = 0;
    for (unsigned seed = 0; seed < 6; ++seed) {
        const Zigzag part = zigzag(seed, seed % 2 == 0 ? 0.1 : 0.25, 40);
        const Run outcome = run(machine("model = \"linuxcnc-2.9\"", kThreeSlides),
                                "G21 G64 P0.05 F1200\n" + part.program + "M2\n");
        const double requested_mm = apart(part.points, outcome.driven);
        EXPECT_NEAR(outcome.blends["max_deviation_mm"].get<double>(), requested_mm,
                    0.01 * requested_mm + 1e-4)
            << seed;
        EXPECT_EQ(outcome.blends["max_deviation_mm"], outcome.blends["feed"]["max_deviation_mm"]);
        EXPECT_EQ(outcome.blends["rapid"]["max_deviation_mm"], 0);
        EXPECT_TRUE(outcome.blends["rapid"]["line"].is_null());
        max = std::max(max, requested_mm);
    }
    EXPECT_GT(max, 0.06) << "more than the tolerance of one corner";
}

TEST_F(PathDeviationMonitor, MatchesTrajectoryForParabolasAndArcs) {
    for (const std::string mode : {"G64", "G64 P0.4 Q0"}) {
        for (unsigned seed = 0; seed < 4; ++seed) {
            const Zigzag part = zigzag(seed, seed % 2 == 0 ? 0.2 : 3, 20);
            const Run outcome = run(machine("model = \"linuxcnc-2.9\"", kThreeSlides),
                                    "G21 " + mode + " F3000\n" + part.program + "M2\n");
            const double requested_mm = apart(part.points, outcome.driven);
            EXPECT_NEAR(outcome.blends["max_deviation_mm"].get<double>(), requested_mm,
                        0.01 * requested_mm + 2e-3)
                << mode << ' ' << seed;
            EXPECT_EQ(outcome.blends["count"], 19);
        }
    }
}

// The parabola that cuts d off both lines of a right angle passes the corner by d sqrt(2) / 4.
TEST_F(PathDeviationMonitor, MatchesClosedFormForParabola) {
    const Run outcome =
        run(machine("model = \"blend\"\ncorner = \"parabolic-blend\"\nblend_tolerance_mm = 20", kThreeSlides),
            "G21 G64 F30000\nG1 X10\nY10\nM2\n");
    const double cut_mm = 4;  // 0.4 of a line
    EXPECT_NEAR(outcome.blends["feed"]["max_deviation_mm"].get<double>(), cut_mm * std::sqrt(2) / 4, 1e-9);
    EXPECT_EQ(outcome.blends["count"], 1);
    EXPECT_EQ(outcome.blends["feed"]["line"], 3) << "the move behind the corner";
}

TEST_F(PathDeviationMonitor, SeparatesFeedAndRapid) {
    const Run outcome = run(machine("model = \"blend\"", kThreeSlides),
                            "G21 G64 P0.02 F600\nG1 X30\nY30\nG64 P0.5\nG0 X0\nY0\nG0 X10\nM2\n");
    EXPECT_NEAR(outcome.blends["feed"]["max_deviation_mm"].get<double>(), 0.02, 1e-9);
    EXPECT_EQ(outcome.blends["feed"]["line"], 3);
    EXPECT_NEAR(outcome.blends["rapid"]["max_deviation_mm"].get<double>(), 0.5, 1e-9);
    EXPECT_EQ(outcome.blends["rapid"]["line"], 6);
    EXPECT_EQ(outcome.blends["max_deviation_mm"], outcome.blends["rapid"]["max_deviation_mm"]);
    const Ended text = gsim_run({"part.ngc", "--dialect", "rs274ngc", "--machine", "m.toml"});
    EXPECT_NE(text.out.find("rounded     4 corners\n"
                            "  feed      max deviation 0.0200 mm, at part.ngc:3\n"
                            "  rapid     max deviation 0.5000 mm, at part.ngc:6\n"),
              std::string::npos)
        << text.out;
}

// Half a degree about a part of 400 mm radius is 3.5 mm at its rim, though no slide is off by more than
// the tolerance.
TEST_F(PathDeviationMonitor, MeasuresTcpOnTurningPart) {
    struct Target {
        double x_mm, a_deg;
    };
    const std::vector<Target> targets{{20, 0}, {20, 12}, {45, 16}, {60, 2}, {60, -9}};
    for (const std::string controller :
         {"model = \"blend\"\nblend_tolerance_deg = 2", "model = \"linuxcnc-2.9\""}) {
        std::string program = "G21 G64 P0.05\nG0 Z400\nG61.1 G1 Z400 F6000 X0\nG64 P0.05\n";
        Points programmed{{0, 0, 400}};
        Target from{0, 0};
        for (const Target& to : targets) {
            program += fmt::format("G1 X{} A{}\n", to.x_mm, to.a_deg);
            for (int i = 1; i <= 400; ++i) {
                const double share = i / 400.0;
                programmed.push_back(on_part({from.x_mm + share * (to.x_mm - from.x_mm), 0, 400},
                                             from.a_deg + share * (to.a_deg - from.a_deg)));
            }
            from = to;
        }
        Run outcome = run(machine(controller, kWrap), program + "M2\n");
        std::erase_if(outcome.driven,
                      [](const Vector3d& at) { return at.norm() < 399.9; });  // on the path up
        const double requested_mm = apart(programmed, outcome.driven);
        EXPECT_GT(requested_mm, 0.5) << controller;
        EXPECT_NEAR(outcome.blends["feed"]["max_deviation_mm"].get<double>(), requested_mm,
                    0.01 * requested_mm)
            << controller;
    }
}

TEST_F(PathDeviationMonitor, ReportsZeroForExactCorners) {
    for (const std::string controller : {"model = \"exact-stop\"", "model = \"ab9\""}) {
        const Run outcome =
            run(machine(controller, kThreeSlides), "G21 F3000\nG1 X10\nY10\nG2 X20 Y0 R10\nG0 X0\nM2\n");
        EXPECT_EQ(outcome.blends["count"], 0);
        EXPECT_EQ(outcome.blends["max_deviation_mm"], 0);
        EXPECT_TRUE(outcome.blends["line"].is_null());
    }
}

}  // namespace
}  // namespace gsim::apps::way_deviation_test
