#include "runtime/script/paths/contour_selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::script::contour_choice_test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

std::vector<ContourDescription> two() {
    ContourDescription hole{
        .face = "the plane face #40 at (1, 2, 3)", .is_hole = true, .is_open = false, .length_mm = 30};
    hole.low_mm = {1, 2, 3};
    hole.high_mm = {11, 12, 3};
    hole.normal = {0, 0, 1};
    hole.depth_mm = 6;
    hole.tilt_deg = 12;
    hole.edges = {{"edge #1 of the plane face #41", 20}, {"edge #2 of the plane face #42", 10}};
    ContourDescription outline{
        .face = "the plane face #50 at (0, 0, 3)", .is_hole = false, .is_open = true, .length_mm = 400};
    return {hole, outline};
}

std::vector<bool> selected(const std::string& lua) {
    const auto found = choose_contours(lua, "choose.lua", two());
    EXPECT_TRUE(found) << found.error().message;
    return found.value_or(std::vector<bool>{});
}

std::string error(const std::string& lua, const LuaState::Limits& limits = {}) {
    const auto found = choose_contours(lua, "choose.lua", two(), limits);
    return found ? "" : found.error().message;
}

TEST(ContourSelection, CallsFunctionForEachContourInOrder) {
    EXPECT_EQ(selected("return function(contour) return contour.is_hole end"), (std::vector{true, false}));
    EXPECT_EQ(selected("return function(contour) return contour.is_open end"), (std::vector{false, true}));
    EXPECT_EQ(selected("return function(contour) return contour.length_mm > 100 end"),
              (std::vector{false, true}));
    EXPECT_EQ(selected("local n = 0\nreturn function() n = n + 1 if n == 2 then return true end end"),
              (std::vector{false, true}));
}

TEST(ContourSelection, PassesAllPropertiesToFunction) {
    EXPECT_EQ(selected(R"lua(
        return function(c)
          if not c.is_hole then return false end
          assert(c.face == "the plane face #40 at (1, 2, 3)")
          assert(c.low_mm.x == 1 and c.low_mm.y == 2 and c.low_mm.z == 3 and c.high_mm.x == 11 and c.high_mm.y == 12)
          assert(c.normal.z == 1 and c.depth_mm == 6 and c.tilt_deg == 12 and c.lean_deg == 12 and c.length_mm == 30)
          assert(#c.edges == 2 and c.edges[2].name == "edge #2 of the plane face #42" and c.edges[2].length_mm == 10)
          return true
        end)lua"),
              (std::vector{true, false}));
}

TEST(ContourSelection, RejectsInvalidScriptWithSourceLocation) {
    EXPECT_THAT(error("return 5"),
                HasSubstr("choose.lua:1: the script must return a function with a contour"));
    EXPECT_THAT(error("return function() return 1 end"),
                AllOf(HasSubstr("choose.lua:1:"), HasSubstr("true or false"),
                      HasSubstr("the plane face #40 at (1, 2, 3) it returns a number")));
    EXPECT_THAT(error("return function(c)\n return c.nothing.x end"), HasSubstr("choose.lua:2:"));
    EXPECT_THAT(error("return function("), HasSubstr("choose.lua:1:"));
    EXPECT_THAT(error("return io.open"), HasSubstr("choose.lua:1:"));
    EXPECT_THAT(error("return function(c)\n while true do end end", {.steps = 100'000}),
                HasSubstr("choose.lua:2: the script exceeds the allowed number of steps"));
    EXPECT_THAT(error("local t = {}\nwhile true do t[#t + 1] = ('x'):rep(1000) end",
                      {.memory_bytes = std::size_t{4} << 20U}),
                HasSubstr("choose.lua:"));
}

}  // namespace
}  // namespace gsim::script::contour_choice_test
