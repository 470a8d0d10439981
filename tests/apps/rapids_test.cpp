// Rapids that are not interpolated, from the outside: every check of a move's path sees the driven one.

#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/robots/slides.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::rapids_test {
namespace {

using nlohmann::json;

constexpr double kSpeed_mm_s = 1000;  // of slides()

/// X300 Y100 from 0: straight, or with both axes to (100, 100), where Y arrives, and on along X.
const std::string kProgram = "G0 X300 Y100\nM30\n";

/// The slides with an acceleration each (mm/s2; 0: without limit).
std::string make_machine(bool interpolated, double acceleration_mm_s2) {
    std::string text = slides("slides");
    if (acceleration_mm_s2 > 0) {
        const std::string speed = "max_speed_mm_s = 1000.0\n";
        const std::string limit = fmt::format("max_acceleration_mm_s2 = {:.1f}\n", acceleration_mm_s2);
        for (std::size_t at = text.find(speed); at != std::string::npos; at = text.find(speed, at + 1))
            text.insert(at + speed.size(), limit);
    }
    return text + fmt::format("[controller]\ninterpolated_rapids = {}\n", interpolated);
}

/// Returns a post of 20 by 20 mm, and a ball of 10 mm at the TCP.
std::string post_at(double x_mm, double y_mm) {
    return fmt::format(
        "[cell]\nname = \"post\"\nclearance_mm = 6.0\n[[object]]\nname = \"post\"\nshape = {{ box_mm = "
        "[20.0, 20.0, 20.0] }}\n"
        "frame = {{ x_mm = {:.1f}, y_mm = {:.1f} }}\n[[shape]]\nname = \"tip\"\non = \"tool\"\n"
        "shape = {{ sphere_mm = 10.0 }}\n",
        x_mm, y_mm);
}

class Rapids : public Apps {
  protected:
    json report(bool interpolated, double acceleration_mm_s2, std::vector<std::string> arguments,
                int status) {
        arguments.insert(arguments.end(),
                         {"--machine", write("m.toml", make_machine(interpolated, acceleration_mm_s2)),
                          "--json", write("part.nc", kProgram)});
        const Ended e = gsim_run(arguments);
        EXPECT_EQ(e.status, status) << e.err << e.out;
        return text::try_parse_json<json>(e.out);
    }
};

TEST_F(Rapids, CollisionsFollowDrivenPath) {
    for (const double acceleration : {0.0, 1e5, 1e4}) {
        SCOPED_TRACE(acceleration);
        for (const bool interpolated : {true, false}) {
            const std::string at_corner = write("corner.toml", post_at(100, 100));
            const std::string on_line = write("line.toml", post_at(210, 70));
            EXPECT_EQ(
                report(interpolated, acceleration, {"--cell", at_corner}, interpolated ? 0 : 1)["collisions"]
                    .size(),
                interpolated ? 0U : 1U);
            EXPECT_EQ(
                report(interpolated, acceleration, {"--cell", on_line}, interpolated ? 1 : 0)["collisions"]
                    .size(),
                interpolated ? 1U : 0U);
        }
    }
}

TEST_F(Rapids, CollisionHasCorrectTime) {
    // The ball touches the post at X90 when its middle is at X85 or Y85, both at once.
    const json r = report(false, 0, {"--cell", write("cell.toml", post_at(100, 100))}, 1);
    const double touch_mm = 90 - 5 / std::sqrt(2.0);
    EXPECT_NEAR(r["collisions"][0]["t_s"].get<double>(), touch_mm / kSpeed_mm_s, 1e-6);
}

TEST_F(Rapids, NearMissesFollowDrivenPath) {
    const json r = report(false, 0, {"--cell", write("cell.toml", post_at(104, 120))}, 0);
    ASSERT_EQ(r["clearances"].size(), 1U);
    EXPECT_NEAR(r["clearances"][0]["clearance_mm"].get<double>(), 5, 1e-3) << "along Y100";
    EXPECT_EQ(report(true, 0, {"--cell", "cell.toml"}, 0)["clearances"].size(), 0U);
}

TEST_F(Rapids, ZoneViolationsFollowDrivenPath) {
    const auto zone = [](double x_mm, double y_mm) {
        return fmt::format("NCFILE\nSECURITY\n1 {} {} {} {} - - ENTER\nENDFILE\n", x_mm - 10, x_mm + 10,
                           y_mm - 10, y_mm + 10);
    };
    for (const double acceleration : {0.0, 1e4}) {
        SCOPED_TRACE(acceleration);
        for (const bool interpolated : {true, false}) {
            const std::string at_corner = write("corner.txt", zone(100, 100));
            const std::string on_line = write("line.txt", zone(210, 70));
            const json corner =
                report(interpolated, acceleration, {"--machine-data", at_corner}, interpolated ? 0 : 1);
            EXPECT_EQ(corner["violation_count"], interpolated ? 0 : 1);
            const json line =
                report(interpolated, acceleration, {"--machine-data", on_line}, interpolated ? 1 : 0);
            EXPECT_EQ(line["violation_count"], interpolated ? 1 : 0);
            if (!interpolated && acceleration == 0) {
                EXPECT_NEAR(corner["violations"][0]["t_s"].get<double>(), 0.09, 1e-9);
            }
        }
    }
}

// The alarm cuts the current segment.
TEST_F(Rapids, AlarmStopsOnDrivenPath) {
    const std::string zone = write("z.txt", "NCFILE\nSECURITY\n1 150 160 90 110 - - ENTER\nENDFILE\n");
    const json r = report(false, 0, {"--machine-data", zone, "--stop-at-first", "--moves", "m.jsonl"}, 1);
    EXPECT_EQ(r["status"], "alarm");
    EXPECT_NEAR(r["cycle_time_s"].get<double>(), 0.15, 1e-9);
    EXPECT_NEAR(r["length"]["rapid_mm"].get<double>(), 100 * std::sqrt(2.0) + 50, 1e-6);
}

TEST_F(Rapids, LengthTrajectoryAndBoundFollowDrivenPath) {
    const json r = report(false, 0, {"--explain", "--trajectory", "t.csv", "--step", "0.05"}, 0);
    EXPECT_NEAR(r["cycle_time_s"].get<double>(), 0.3, 1e-9);
    EXPECT_NEAR(r["length"]["rapid_mm"].get<double>(), 100 * std::sqrt(2.0) + 200, 1e-6);
    EXPECT_NEAR(r["lower_bound_s"].get<double>(), 0.3, 1e-9);
    const std::string trajectory = read("t.csv");
    EXPECT_TRUE(contains(trajectory, "\n0.05,1,50,50,0,1414.2")) << trajectory;
    EXPECT_TRUE(contains(trajectory, "\n0.15,1,150,100,0,1000\n")) << trajectory;
}

// Our own planner runs in steps as a module: the module receives the rule.
TEST_F(Rapids, ModuleReceivesInterpolationRule) {
    const json r =
        report(false, 1e4,
               {"--rcs", tests::default_module_path(), "--cell", write("cell.toml", post_at(100, 100))}, 1);
    EXPECT_EQ(r["collisions"].size(), 1U);
}

TEST_F(Rapids, CyclesAndHomingUseUninterpolatedRapids) {
    write("m.toml", make_machine(false, 0));
    write("z.txt", "NCFILE\nSECURITY\n1 90 110 90 110 - - ENTER\nENDFILE\n");
    for (const char* program : {"G81 X300 Y100 Z-1 R0 F600\nG80\nM30\n", "G91 G28 X300 Y100\nM30\n"}) {
        const Ended e = gsim_run({"--machine", "m.toml", "--machine-data", "z.txt", write("p.nc", program)});
        EXPECT_EQ(e.status, 1) << program << e.out << e.err;
        EXPECT_TRUE(contains(e.out + e.err, "security zone 1")) << program << e.out << e.err;
    }
}

TEST_F(Rapids, RejectsSettingsIncompatibleWithInterpolationOff) {
    const auto error_of = [&](const std::string& machine) {
        const Ended e = gsim_run({"--machine", write("m.toml", machine), write("part.nc", kProgram)});
        EXPECT_EQ(e.status, 2);
        return e.err;
    };
    EXPECT_TRUE(contains(error_of(make_machine(false, 0) + "planner = \"look-ahead\"\n"),
                         "'interpolated_rapids = false' needs the planner \"rest-to-rest\": in the others "
                         "all axes move in proportion"));
    EXPECT_TRUE(contains(error_of(make_machine(false, 0) + "[path]\nmax_rapid_mm_s = 500.0\n"),
                         "'interpolated_rapids = false' cannot be combined with 'max_rapid_mm_s': each axis "
                         "has its own speed, so the tool speed is not limited"));
}

}  // namespace
}  // namespace gsim::apps::rapids_test
