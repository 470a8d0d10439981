// A turntable that turns while the tool cuts (samples/mill/turntable.nc), against what geometry says of it.

#include <cmath>
#include <sstream>
#include <vector>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::turntable_test {
namespace {

using nlohmann::json;
using Turntable = Apps;

constexpr double kRadius_mm = 80;  // of the groove, from the table's axis
constexpr double kFeed_mm_s = 40;  // F2400
constexpr double kSpeed_deg_s = kFeed_mm_s / kRadius_mm * 180 / M_PI;
constexpr double kAcceleration_deg_s2 = 1000;  // of C
constexpr double kRamp_s = kSpeed_deg_s / kAcceleration_deg_s2;
constexpr double kQuarter_s = 90 / kSpeed_deg_s + kRamp_s;

std::vector<std::string> on_the_table(std::vector<std::string> arguments) {
    const std::string samples = tests::source_path("samples/");
    arguments.insert(arguments.end(), {samples + "mill/turntable.nc", "--machine",
                                       samples + "machines/mill-table-table.toml"});
    return arguments;
}

struct Sample {
    double t_s, line, x_mm, y_mm, z_mm, a_deg, c_deg, speed_mm_s;
};

std::vector<Sample> samples_of(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "t_s,line,x_mm,y_mm,z_mm,a_deg,c_deg,speed_mm_s");
    std::vector<Sample> samples;
    char comma = 0;
    while (std::getline(lines, line)) {
        Sample s{};
        std::istringstream(line) >> s.t_s >> comma >> s.line >> comma >> s.x_mm >> comma >> s.y_mm >> comma >>
            s.z_mm >> comma >> s.a_deg >> comma >> s.c_deg >> comma >> s.speed_mm_s;
        samples.push_back(s);
    }
    return samples;
}

// A point of the table has the speed that its distance from the axis gives it, and the axis decides how soon.
TEST_F(Turntable, EachQuarterTakesComputedTime) {
    const Ended e = gsim_run(on_the_table({"--moves", "moves.jsonl", "--quiet"}));
    ASSERT_EQ(e.status, 0) << e.err;
    std::istringstream moves(read("moves.jsonl"));
    int quarters = 0;
    for (std::string line; std::getline(moves, line);) {
        const json move = text::parse_json<json>(line);
        if (move["kind"] != "arc_ccw") continue;
        ++quarters;
        EXPECT_NEAR(move["end_s"].get<double>() - move["start_s"].get<double>(), kQuarter_s, 1e-8);
        EXPECT_NEAR(move["to"]["C"], 90 * quarters, 1e-9);
        EXPECT_NEAR(move["to"]["X"], kRadius_mm, 1e-9) << "the tool stands";
        EXPECT_NEAR(move["to"]["Y"], 0, 1e-9);
    }
    EXPECT_EQ(quarters, 4);
}

TEST_F(Turntable, PointUnderStationaryToolMovesAtFeed) {
    ASSERT_EQ(gsim_run(on_the_table({"--trajectory", "t.csv", "--step", "0.001", "--quiet"})).status, 0);
    const std::vector<Sample> all = samples_of(read("t.csv"));
    int at_speed = 0;
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
        const Sample &before = all[i - 1], &now = all[i], &after = all[i + 1];
        if (before.line < 10 || before.line > 13 || before.line != after.line) continue;
        EXPECT_NEAR(now.x_mm, kRadius_mm, 1e-6);
        EXPECT_NEAR(now.y_mm, 0, 1e-6);
        const double deg_s = (after.c_deg - before.c_deg) / (after.t_s - before.t_s);
        EXPECT_LE(deg_s, kSpeed_deg_s + 1e-3);
        EXPECT_NEAR(deg_s * M_PI / 180 * kRadius_mm, now.speed_mm_s, 0.8) << now.t_s;  // a step of the ramp
        at_speed += std::abs(deg_s - kSpeed_deg_s) < 1e-3 ? 1 : 0;
    }
    EXPECT_NEAR(at_speed * 0.001, 4 * (kQuarter_s - 2 * kRamp_s), 0.02);
}

}  // namespace
}  // namespace gsim::apps::turntable_test
