// gsim-run --cell: collisions and near misses.

#include <cmath>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::cell_test {
namespace {

using nlohmann::json;

class Cell : public Apps {
  protected:
    json report(const std::string& program, int status) {
        const Ended e = gsim_run({program, "--cell", cell_, "--json"});
        EXPECT_EQ(e.status, status) << e.err;
        return text::parse_json<json>(e.out);
    }
    const std::string cell_ = write("cell.toml", R"(
[cell]
name = "a post"
clearance_mm = 3.0
[[object]]
name = "post"
shape = { box_mm = [20.0, 20.0, 20.0] }
frame = { x_mm = 200.0, y_mm = 200.0 }
[[shape]]
name = "tip"
on = "tool"
shape = { sphere_mm = 10.0 }
)");
};

TEST_F(Cell, ReportsCollisionsAndNearMisses) {
    const json r = report(write("part.nc", "G1 X100 Y216 F6000\nX300\nY100\nG1 X100 Y200\nX200\n"), 1);
    EXPECT_EQ(r["status"], "completed");
    EXPECT_EQ(r["cell"]["name"], "a post");
    ASSERT_EQ(r["clearances"].size(), 2U);
    EXPECT_EQ(r["clearances"][0]["line"], 2);
    EXPECT_NEAR(r["clearances"][0]["clearance_mm"].get<double>(), 1, 1e-3);
    ASSERT_EQ(r["collisions"].size(), 1U);
    EXPECT_EQ(r["collisions"][0]["line"], 5);
    EXPECT_EQ(r["collisions"][0]["pair"], (json{"tip", "post"}));
    EXPECT_EQ(r["collisions"][0]["kind"], "penetrating");
    EXPECT_NEAR(r["collisions"][0]["point_mm"][0].get<double>(), 190, 1e-5);
    EXPECT_EQ(r["clearances"][1]["clearance_mm"], 0);
    EXPECT_EQ(r["clearances"][1]["point_mm"], r["collisions"][0]["point_mm"]);
}

TEST_F(Cell, ScriptMovesFrameOutOfPath) {
    const std::string script = write("part.lua", R"(local _ENV = require "gsim"
F(6000) G1{x=150, y=200}
local status, pose = rrs.GetCellFrame("post")
assert(status == 0 and pose[1][4] == 200, "frame")
pose[1][4] = 400
assert(rrs.ModifyCellFrame("post", pose) == 0)
assert(rrs.ModifyCellFrame("X", pose) < 0 and rrs.ModifyCellFrame("pots", pose) < 0)
G1{x=300}
)");
    const Ended e = gsim_run({script, "--cell", cell_, "--json"});
    EXPECT_EQ(e.status, 0) << e.err << e.out;
}

// A contact from before a frame was moved remains, though the moves were still pending in the planner.
TEST_F(Cell, FrameMovesAfterPendingMoves) {
    const std::string script = write("part.lua", R"(local _ENV = require "gsim"
F(6000) G1{x=150, y=200}
G1{x=250}
local status, pose = rrs.GetCellFrame("post")
pose[2][4] = 400
assert(rrs.ModifyCellFrame("post", pose) == 0)
G1{x=150}
)");
    const json r = report(script, 1);
    ASSERT_EQ(r["collisions"].size(), 1U);
    EXPECT_EQ(r["collisions"][0]["line"], 3);
}

TEST_F(Cell, ScriptTargetsUseCellFrames) {
    const std::string script = write("part.lua", R"(local _ENV = require "gsim"
G0{x=250, y=250, z=50}
assert(rrs.SelectWorkFrames("tip", "pst") == -10)
local _, message = rrs.GetMessage()
assert(message:find("did you mean 'post'?", 1, true), message)
assert(rrs.SelectWorkFrames("tip", "post") == 0)
assert(rrs.SelectTargetType("cartesian") == 0 and rrs.SelectMotionType("linear") == 0)
local _, joints, pose = rrs.GetNextStep()
rrs.SetCartesianPositionSpeed(100)
for _, at in ipairs{{100, 20, 30}, {-60, 40, 35}} do
  for i = 1, 3 do pose[i][4] = at[i] end
  assert(rrs.SetNextTarget(pose) == 0, select(2, rrs.GetMessage()))
end
F(6000) MoveLinear{x=-60, y=100, z=35}
)");
    const json r = report(script, 0);
    EXPECT_NEAR(r["bounds"]["X"]["max"].get<double>(), 200 + 100, 1e-9);
    EXPECT_NEAR(r["bounds"]["Y"]["max"].get<double>(), 200 + 100, 1e-9);
}

TEST_F(Cell, ChecksObjectMovedByScript) {
    const std::string script = write("part.lua", R"(local _ENV = require "gsim"
F(6000) G1{x=150, y=200}
assert(rrs.SelectObject("tool") < 0 and rrs.SelectObject("psot") < 0)
assert(rrs.SelectObject("post") == 0)
assert(rrs.SetObjectSpeed(10) == 0)
local _, pose = rrs.GetCellFrame("post")
pose[1][4] = 100
assert(rrs.SetObjectNextTarget(pose) == 0)
assert(rrs.SelectWorkFrames("tip", "post") < 0)
wait(2)
_, pose = rrs.GetCellFrame("post")
assert(math.abs(pose[1][4] - 180) < 1e-9, "on its way")
wait(8)
)");
    const json r = report(script, 1);
    ASSERT_EQ(r["collisions"].size(), 1U);
    EXPECT_NEAR(r["collisions"][0]["t_s"].get<double>(),
                r["cycle_time_s"].get<double>() - 10 + (190 - 155) / 10.0, 1e-6);
}

TEST_F(Cell, ReportsCollisionInSampleCell) {
    const std::string part = write("part.nc", "G0 X200 Y200 Z50\nG0 X1500 Y400\nG1 Z100 F3000\nG0 Z50\n");
    const std::string cell = tests::source_path("samples/cell/table.toml");
    const Ended e = gsim_run({part, "--cell", cell});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.out, "nozzle end and mould")) << e.out;
    const Ended quiet = gsim_run({part, "--cell", cell, "--quiet"});
    EXPECT_TRUE(contains(quiet.err, "collisions: ")) << quiet.err;
}

/// Returns a cell file text with one of its clamps moved along the clamp's own X.
std::string with_clamp_moved(std::string text, int clamp, double by_mm) {
    const std::string head = fmt::format("name = \"clamp {}\"\n", clamp);
    const std::size_t frame = text.find("frame = {", text.find(head));
    const double angle = (45 + 90 * (clamp - 1)) * M_PI / 180;
    const double at_mm = 300 + by_mm;
    return text.replace(frame, text.find(", z_mm", frame) - frame,
                        fmt::format("frame = {{ x_mm = {:.4f}, y_mm = {:.4f}", at_mm * std::cos(angle),
                                    at_mm * std::sin(angle)));
}

// The rim is cut on a circle of 215.9 mm; a clamp's end is 240 mm from its middle, and the nozzle has 7.14
// mm.
TEST_F(Cell, WheelCellIsCollisionFreeUntilClampIsMoved) {
    const std::string samples = tests::source_path("samples/");
    const auto run = [&](const std::string& cell, int status) {
        const Ended e = gsim_run({samples + "wheel.nc", "--cell", cell, "--json"});
        EXPECT_EQ(e.status, status) << e.err;
        return text::parse_json<json>(e.out);
    };
    const json is_clean = run(samples + "cell/wheel.toml", 0);
    EXPECT_EQ(is_clean["collisions"].size() + is_clean["clearances"].size(), 0U);
    const json& looked = is_clean["cell"]["checked"];
    EXPECT_EQ(looked["objects"], 12);
    EXPECT_EQ(looked["jets"], 1);
    EXPECT_GT(looked["pairs"], 300);

    std::string text = read(samples + "cell/wheel.toml");
    for (const auto& [from, to] : {std::pair("\"../machines/", samples + "machines/"),
                                   std::pair("\"wheel.obj", samples + "cell/wheel.obj")}) {
        const std::string_view word(from);
        text.replace(text.find(word), word.size(), "\"" + to);
    }
    for (const int clamp : {1, 2, 3, 4}) {
        EXPECT_EQ(run(write("nearer.toml", with_clamp_moved(text, clamp, -19)), 0)["collisions"].size(), 0U);
        const json hit = run(write("hit.toml", with_clamp_moved(text, clamp, -30)), 1)["collisions"];
        ASSERT_EQ(hit.size(), 3U);
        EXPECT_EQ(hit[0]["pair"], json::array({"nozzle", fmt::format("clamp {}", clamp)}));
        EXPECT_EQ(hit[0]["line"], clamp == 2 || clamp == 3 ? 15 : 16);
        const double x = hit[0]["point_mm"][0].get<double>() - 500;
        const double y = hit[0]["point_mm"][1].get<double>() - 500;
        EXPECT_NEAR(std::hypot(x, y), 215.9, 7.14 / 2 + 1e-3);
    }
}

TEST_F(Cell, ReportsFileErrorsAsUsageErrors) {
    const std::string part = write("part.nc", "G0 X1\n");
    const Ended e = gsim_run({part, "--cell", write("bad.toml", "[cell]\nname = 3\n")});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "bad.toml:2:")) << e.err;
    EXPECT_EQ(gsim_run({part, "--cell", "none.toml"}).status, 2);
}

}  // namespace
}  // namespace gsim::apps::cell_test
