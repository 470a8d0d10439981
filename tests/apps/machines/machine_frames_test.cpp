// rrs.ModifyCellFrame of the machine's own frames, "tool" and "base", from a script to the report.

#include <cmath>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/robots/slides.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::machine_frames_test {
namespace {

using nlohmann::json;

/// The near side of the plate is touched if the tool's centre is at x = 294.5.
constexpr const char* kPlate = R"(
[cell]
name = "a plate"
[[object]]
name = "plate"
shape = { box_mm = [1.0, 600.0, 400.0] }
frame = { x_mm = 300.0 }
[[shape]]
name = "tip"
on = "tool"
shape = { sphere_mm = 10.0 }
)";

constexpr const char* kMoveBase = R"(
local function move_base(x, y, roll_deg)
  local c, s = math.cos(math.rad(roll_deg)), math.sin(math.rad(roll_deg))
  assert(rrs.ModifyCellFrame("base", {{c, -s, 0, x}, {s, c, 0, y}, {0, 0, 1, 0}, {0, 0, 0, 1}}) == 0)
end
)";

class MachineFrames : public Apps {
  protected:
    std::string script(const std::string& body) const {
        return write("part.lua",
                     fmt::format("local _ENV = require \"gsim\"\n{}F(6000)\n{}", kMoveBase, body));
    }
    json run(const std::vector<std::string>& arguments, int status) const {
        std::vector<std::string> all = arguments;
        all.emplace_back("--json");
        const Ended e = gsim_run(all);
        EXPECT_EQ(e.status, status) << e.err << e.out;
        return text::try_parse_json<json>(e.out);
    }
    double contact_s(const std::string& body, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{script(body), "--machine", machine_, "--cell", cell_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const json report = run(arguments, 1);
        if (report["collisions"].size() != 1) return NAN;
        EXPECT_EQ(report["collisions"][0]["pair"], (json{"tip", "plate"}));
        return report["collisions"][0]["t_s"].get<double>();
    }
    const std::string machine_ = write("slides.toml", slides("slides"));
    const std::string cell_ = write("cell.toml", kPlate);
};

TEST_F(MachineFrames, MovedBaseReachesPlateAtComputedTime) {
    EXPECT_NEAR(contact_s("G1{x=280} G1{x=290} G1{x=300}"), 2.945, 1e-6);
    EXPECT_NEAR(contact_s("move_base(120, 0, 0) G1{x=200}"), (294.5 - 120) / 100, 1e-6);
    EXPECT_NEAR(contact_s("G1{x=50} move_base(120, 0, 0) G1{x=200}"), (294.5 - 120) / 100, 1e-6);
    const double slope = std::cos(30 * M_PI / 180);
    EXPECT_NEAR(contact_s("move_base(120, -40, 30) G1{x=250}"), (294.5 - 120) / slope / 100, 1e-6);
    const json report =
        run({script("move_base(120, -40, 30) G1{x=250}"), "--machine", machine_, "--cell", cell_}, 1);
    EXPECT_NEAR(report["collisions"][0]["point_mm"][0].get<double>(), 299.5, 1e-5);
    EXPECT_NEAR(report["collisions"][0]["point_mm"][1].get<double>(),
                -40 + (294.5 - 120) * std::tan(30 * M_PI / 180), 1e-4);
}

// The path to 200 would hit the plate from the base that the later moves have.
TEST_F(MachineFrames, EarlierMovesUseEarlierBase) {
    const std::string part = script("G1{x=200} G1{x=0} move_base(120, 0, 0) G1{x=150} G1{x=0}");
    EXPECT_TRUE(run({part, "--machine", machine_, "--cell", cell_}, 0)["collisions"].empty());
}

TEST_F(MachineFrames, ChangedTcpMovesNoBody) {
    EXPECT_NEAR(contact_s("rrs.ModifyCellFrame('tool', {{1, 0, 0, 50}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, "
                          "1}}) G1{x=300}"),
                2.945, 1e-6);
}

constexpr const char* kPoses = R"(
G1{x=900, y=900, z=300}
assert(rrs.SelectTargetType("cartesian") == 0 and rrs.SelectMotionType("linear") == 0)
rrs.SetCartesianPositionSpeed(100)
local function at()
  local status, joints, pose
  repeat status, joints, pose = rrs.GetNextStep() until rrs.status_name(status) == "RRS_NEED_MORE_DATA"
  return pose
end
local before = at()
)";

// By services and by words, without a cell and in one.
TEST_F(MachineFrames, ServiceTargetsUseChangedFrames) {
    const std::string part = script(std::string(kPoses) + R"(
local _, tool = rrs.GetCellFrame("tool")
tool[1][4] = tool[1][4] + 30
tool[3][4] = tool[3][4] + 40
assert(rrs.ModifyCellFrame("tool", tool) == 0)
local now = at()
local d = {}
for i = 1, 3 do d[i] = now[i][4] - before[i][4] end
assert(math.abs(d[1]^2 + d[2]^2 + d[3]^2 - 50^2) < 1e-6, "the tip is 50 mm further")
assert(rrs.SetNextTarget(before) == 0, select(2, rrs.GetMessage()))
local joints = select(2, rrs.GetInverseKinematics(before))
for i, axis in ipairs{900, 900, 300} do assert(math.abs(joints[i] - (axis - d[i])) < 1e-6, "tip at the target") end
local _, base = rrs.GetCellFrame("base")
base[1][4] = base[1][4] + 100
assert(rrs.ModifyCellFrame("base", base) == 0)
assert(rrs.SetNextTarget(before) == 0, select(2, rrs.GetMessage()))
joints = select(2, rrs.GetInverseKinematics(before))
assert(math.abs(joints[1] - (900 - d[1] - 100)) < 1e-6, "from the other base")
)");
    const json standalone = run({part}, 0);
    EXPECT_EQ(standalone["status"], "completed");
    EXPECT_TRUE(standalone["collisions"].empty());
    const json in_cell = run({part, "--cell", write("empty.toml", "[cell]\nname = \"c\"\n")}, 0);
    EXPECT_EQ(in_cell["bounds"], standalone["bounds"]);
}

TEST_F(MachineFrames, RejectTheirNamesInCells) {
    for (const char* name : {"tool", "base"}) {
        const std::string cell =
            write("named.toml", fmt::format("[cell]\nname = \"c\"\n[[frame]]\nname = \"{}\"\n", name));
        const Ended e = gsim_run({script("G1{x=1}"), "--machine", machine_, "--cell", cell});
        EXPECT_EQ(e.status, 2);
        EXPECT_TRUE(
            contains(e.err, fmt::format("the name '{}' is already used, by the machine or above", name)))
            << e.err;
    }
}

TEST_F(MachineFrames, AreForwardedToControllerModule) {
    const std::string body = "move_base(120, 0, 0) G1{x=200}";
    EXPECT_NEAR(contact_s(body, {"--rcs", tests::build_path("lib/test_modules/has_base.so")}),
                (294.5 - 120) / 100, 0.01);
    const std::string rejected = script(R"(
local pose = {{1, 0, 0, 120}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}
for _, name in ipairs{"base", "tool"} do
  assert(rrs.status_name(rrs.ModifyCellFrame(name, pose)) == "RRS_SERVICE_NOT_SUPPORTED", name)
  assert(select(2, rrs.GetMessage()):find("ModifyCellFrame", 1, true), select(2, rrs.GetMessage()))
end
G1{x=200}
)");
    const json report =
        run({rejected, "--machine", machine_, "--cell", cell_, "--rcs", tests::default_module_path()}, 0);
    EXPECT_TRUE(report["collisions"].empty());
}

TEST_F(MachineFrames, AreSeparateForEachRobot) {
    write("r.toml",
          "[[robot]]\nname = \"left\"\nmachine = \"slides.toml\"\ncell = \"cell.toml\"\n"
          "[[robot]]\nname = \"right\"\nmachine = \"slides.toml\"\ncell = \"cell.toml\"\n");
    const std::string part = write("cell.lua", R"(
for _, name in ipairs{"left", "right"} do
  process(name, function()
    local _ENV = robot(name)
    F(6000)
    if name == "left" then
      assert(rrs.ModifyCellFrame("base", {{1, 0, 0, 120}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}) == 0)
    end
    G1{x=200}
  end)
end
)");
    const json report = run({"--robots", "r.toml", part}, 1);
    ASSERT_EQ(report["robots"][0]["collisions"].size(), 1U);
    EXPECT_NEAR(report["robots"][0]["collisions"][0]["t_s"].get<double>(), 1.745, 1e-6);
    EXPECT_TRUE(report["robots"][1]["collisions"].empty());
}

}  // namespace
}  // namespace gsim::apps::machine_frames_test
