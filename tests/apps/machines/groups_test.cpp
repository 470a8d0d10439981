// Groups of independent axes in the check for collisions.

#include <cmath>

#include "base/text/json.h"
#include "tests/apps/run_program.h"

namespace gsim::apps::groups_test {
namespace {

using nlohmann::json;
using AxisGroups = Apps;

// A bar on a table, and 150 mm from its axis a ball that a slide lifts by 3 mm.
constexpr const char* kMachine = R"([machine]
name = "bar and ball"
[base]
y_mm = 150.0
[[axis]]
letter = "Z"
kind = "linear"
max_speed_mm_s = 10.0
max_acceleration_mm_s2 = 100.0
direction = "z"
[[axis]]
letter = "C"
kind = "rotary"
carries = "work"
max_speed_deg_s = 30.0
max_acceleration_deg_s2 = 60.0
frame = {}
[[group]]
name = "table"
axes = ["C"]
motion = "independent"
[[shape]]
name = "bar"
on = "work"
shape = { box_mm = [400.0, 10.0, 10.0] }
[[shape]]
name = "ball"
on = "tool"
shape = { sphere_mm = 10.0 }
)";

// The side of the bar meets the ball at 150 mm sin(a) = 5 mm + 5 mm. The angle a is from the bar to the ball.
TEST_F(AxisGroups, IndependentTableHitsToolAtComputedTime) {
    write("bar.toml", kMachine);
    for (const std::string meanwhile : {"F(30) G1{z=3}", "group('table').wait()"}) {
        const std::string script = write("turn.lua", "group('table').move{c=180}\n" + meanwhile + "\n");
        const Ended e = gsim_run({"--machine", "bar.toml", script, "--json"});
        EXPECT_EQ(e.status, 1) << e.err;
        const json report = text::parse_json<json>(e.out);
        ASSERT_FALSE(report["collisions"].empty()) << meanwhile;
        const double angle_deg = 90 - std::asin(10 / 150.0) * 180 / M_PI;
        EXPECT_NEAR(report["collisions"][0]["t_s"].get<double>(), angle_deg / 30 + 30 / 60.0 / 2, 1e-5)
            << meanwhile;
        EXPECT_EQ(report["collisions"][0]["line"], 2);
        EXPECT_NEAR(report["cycle_time_s"].get<double>(), 180 / 30.0 + 30 / 60.0, 0.02) << meanwhile;
    }
}

}  // namespace
}  // namespace gsim::apps::groups_test
