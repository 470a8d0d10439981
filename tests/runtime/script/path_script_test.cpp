// Paths that are built by scripts.
#include "runtime/script/paths/path_script.h"

#include <new>

#include <gtest/gtest.h>

namespace gsim::script::path_script_test {
namespace {

TEST(PathScript, BuildsPointsAndSubPathsInLoops) {
    const auto file = run_path_script(R"lua(
        local row = {name = "row"}
        for i = 1, 3 do
            row[i] = point{position_mm = {10 * i, 0, 5}, feed_mm_min = 100, actions = {"waterjet_on", "x"}}
        end
        local part = path(row)
        return path{name = "part", part, point{motion = "rapid", position_mm = {0, 0, 50},
                    rotary_deg = {B = 1, C = 2}}, repeated(4, part)}
    )lua",
                                      "f.lua");
    ASSERT_TRUE(file) << file.error().message;
    const path::Program& program = file->program;
    ASSERT_EQ(program.paths.size(), 2U);
    EXPECT_EQ(program.paths[program.root].name, "part");
    ASSERT_EQ(program.paths[0].targets.size(), 3U);
    const auto& second = std::get<path::Point>(program.paths[0].targets[1]);
    EXPECT_EQ(second.position_mm, (path::Vector{20, 0, 5}));
    EXPECT_EQ(second.actions, (std::vector<std::string>{"waterjet_on", "x"}));
    const auto& away = std::get<path::Point>(program.paths[1].targets[1]);
    EXPECT_EQ(away.motion, path::MotionType::rapid);
    EXPECT_EQ(std::get<path::RotaryAxes>(*away.orientation), (path::RotaryAxes{{'B', 1}, {'C', 2}}));
    EXPECT_EQ(std::get<path::SubPath>(program.paths[1].targets[2]), (path::SubPath{0, 4}));
    EXPECT_EQ(file->with_location({0, 2}, "x"), "f.lua:4: x");
}

TEST(PathScript, PathsAndRepeatsHaveFramesAndTools) {
    const auto file = run_path_script(R"lua(
        local part = path{name = "part", tool = 3, diameter_offset = 4, point{position_mm = {1, 2, 3}}}
        return path{name = "job", work_offset = "G54", set_offset_mm = {1, 2, 3}, part,
                    repeated(2, part, {work_offset = "G55", set_offset_mm = {4, 5, 6}})}
    )lua",
                                      "f.lua");
    ASSERT_TRUE(file) << file.error().message;
    const path::Program& program = file->program;
    EXPECT_EQ(program.paths[0].tool, (path::Tool{3, 3, 4}));
    EXPECT_EQ(program.paths[1].frame, (path::WorkFrame{"54", path::Vector{1, 2, 3}}));
    EXPECT_EQ(std::get<path::SubPath>(program.paths[1].targets[0]), (path::SubPath{0, 1}));
    EXPECT_EQ(std::get<path::SubPath>(program.paths[1].targets[1]),
              (path::SubPath{0, 2, {"55", path::Vector{4, 5, 6}}}));
}

TEST(PathScript, ReadsMachinePointsAndTouches) {
    const auto file = run_path_script(R"lua(
        local part = path{name = "part", point{reference = 2}, point{motion = "rapid", position_mm = {1, 2, 3}}}
        return path{name = "job", repeated(1, part, {work_offset = "G55", probe_offset = {
            {axis = "Z", from_mm = {1, 2, 9}, to_mm = -1, surface_mm = 0.5, feed_mm_min = 60},
            {axis = "X", from_mm = {-9, 2, 1}, to_mm = 1, surface_mm = 0, feed_mm_min = 60, probe_radius_mm = 2},
        }}), point{fixed = "CLAMP1", name = "left", dwell_s = 2, actions = {"clamp"}}, point{fixed = 7}}
    )lua",
                                      "f.lua");
    ASSERT_TRUE(file) << file.error().message;
    const path::Program& program = file->program;
    EXPECT_EQ(std::get<path::MachinePoint>(program.paths[0].targets[0]).number, 2);
    const std::vector<path::Touch>& touches =
        std::get<path::SubPath>(program.paths[1].targets[0]).frame.touches;
    ASSERT_EQ(touches.size(), 2U);
    EXPECT_EQ(touches[0], (path::Touch{'Z', {1, 2, 9}, -1, 0.5, 60, 0, {}}));
    EXPECT_EQ(touches[1], (path::Touch{'X', {-9, 2, 1}, 1, 0, 60, 2, {}}));
    const auto& left = std::get<path::MachinePoint>(program.paths[1].targets[1]);
    EXPECT_EQ(left.alias, "CLAMP1");
    EXPECT_EQ(left.name, "left");
    EXPECT_EQ(left.dwell_s, 2);
    EXPECT_EQ(left.actions, (std::vector<std::string>{"clamp"}));
    EXPECT_EQ(std::get<path::MachinePoint>(program.paths[1].targets[2]).number, 7);
}

struct Wrong {
    std::string script, error;
};

TEST(PathScript, ReportsErrorsWithLine) {
    const std::vector<Wrong> cases = {
        {"return 3", "f.lua:1: the script must return the root path"},
        {"\nreturn point{position = {1, 2, 3}}", "f.lua:2: unknown key 'position' in a point"},
        {"\nreturn point{position_mm = {1, 2}}", "f.lua:2: 'position_mm' must be a table of three numbers"},
        {"return point{position_mm = {1, 2, 3}, feed_mm_min = 'x'}",
         "f.lua:1: 'feed_mm_min' must be a number"},
        {"return point{motion = 'linear'}", "f.lua:1: a point lacks the key 'position_mm'"},
        {"return path{point{position_mm = {1, 2, 3}}}", "f.lua:1: a path lacks 'name'"},
        {"return path{name = 'a', tool = 'T1'}", "f.lua:1: 'tool' must be a number"},
        {"return path{name = 'a', length_offset = 1}", "f.lua:1: 'length_offset' requires 'tool'"},
        {"return path{name = 'a', tol = 1}",
         "f.lua:1: path{..} needs 'name', 'work_offset', 'set_offset_mm', 'probe_offset', 'tool', "
         "'length_offset', 'diameter_offset' and, in their order, points and sub-paths"},
        {"return repeated(1, path{name = 'a'}, {tool = 1})", "f.lua:1: unknown key 'tool' in a sub-path"},
        {"return path{name = 'a', probe_offset = 1}",
         "f.lua:1: 'probe_offset' must be a table of touches, each a table"},
        {"return path{name = 'a', probe_offset = {}}",
         "f.lua:1: 'probe_offset' must contain at least one touch"},
        {"return path{name = 'a', probe_offset = {7}}",
         "f.lua:1: 'probe_offset' must be a table of touches, each a table"},
        {"return path{name = 'a', probe_offset = {{axis = 'X', depth = 1}}}",
         "f.lua:1: unknown key 'depth' in a touch"},
        {"return path{name = 'a', probe_offset = {{axis = 'X'}}}",
         "f.lua:1: a touch lacks the key 'from_mm'"},
        {"return path{name = 'a', probe_offset = {{axis = 7}}}", "f.lua:1: 'axis' must be a string"},
        {"return path{name = 'a', probe_offset = {{from_mm = {1, 2}}}}",
         "f.lua:1: 'from_mm' must be a table of three numbers"},
        {"return path{name = 'a', 7}", "f.lua:1: target 1 of the path 'a' is neither"},
        {"return path{name = 'a'}", "f.lua:1: the path 'a' has no targets"},
        {"return repeated(0, path{name = 'a'})", "f.lua:1: repeated(n, p)"},
        {"return path{name = 'a',\n point{position_mm = {1, 2, 3}, feed_mm_min = 0/0}}",
         "f.lua:2: 'feed_mm_min' must be greater than 0"},
        {"while true do end", "f.lua:1: the script exceeds the allowed number of steps"},
        {"local t = {} for i = 1, 1e9 do t[i] = {} end",
         "f.lua:1: the script needs more memory than the run may use, 32 MB (--memory): "},
        {"local t = {name = 'a'} for i = 1, 1e9 do t[i] = point{position_mm = {1, 2, 3}} end",
         "f.lua:1: the path of the script needs more memory than the run may use, 32 MB (--memory): "},
        {"local p = point{position_mm = {1, 2, 3}, actions = {('x'):rep(100000)}}\n"
         "local t = {name = 'a'} for i = 1, 1000 do t[i] = p end return path(t)",
         "f.lua:1: the path of the script needs more memory than the run may use, 32 MB (--memory): "},
        {"x = = 1", "f.lua:1: unexpected symbol"},
        {"io.open('x')", "f.lua:1: attempt to index a nil value"},
        {"error({})", "table: 1"},
        {"return point{position_mm = {1, 2, 3}, zulu = 1, alpha = 2, mike = 3}",
         "f.lua:1: unknown key 'alpha' in a point"},
    };
    const LuaState::Limits limits{std::size_t{32} << 20U, 20'000'000};
    for (const Wrong& each : cases) {
        const auto file = run_path_script(each.script, "f.lua", limits);
        ASSERT_FALSE(file) << each.script;
        EXPECT_EQ(file.error().message.substr(0, each.error.size()), each.error) << each.script;
    }
}

// The data that a script receives before it begins takes memory, too.
TEST(PathScript, SurvivesAnyMemoryLimit) {
    const std::string script = "return path{name = 'a', point{position_mm = {1, 2, 3}}}";
    int rejected = 0, made = 0;
    for (std::size_t bytes = 8'000; bytes < 100'000; bytes += 200) {
        try {
            ++(run_path_script(script, "f.lua", {.memory_bytes = bytes}) ? made : rejected);
        } catch (const std::bad_alloc&) {  // not even a state
        }
    }
    EXPECT_GT(rejected, 10);
    EXPECT_GT(made, 10);
}

}  // namespace
}  // namespace gsim::script::path_script_test
