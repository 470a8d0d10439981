#include "engine/translation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::translation_test {
namespace {

using testing::HasSubstr;

std::string lua_of(TranslationRequest request) {
    auto translation = Translation::open(std::move(request));
    EXPECT_TRUE(translation) << translation.error().message;
    EXPECT_TRUE(translation->make({}));
    std::string lua;
    EXPECT_TRUE(translation->write([&](std::string_view text) {
        lua += text;
        return true;
    }));
    return lua;
}

TEST(Translation, ProgramLineNIsLuaLineNPlus1) {
    TranslationRequest request;
    request.text = Text("G0 X1\nG1 Y2 F100\nM2\n", "part.nc");
    const std::string lua = lua_of(request);
    EXPECT_THAT(lua, HasSubstr("part.nc"));
    EXPECT_EQ(lua.find("G1{", 0), lua.find("G1{y=2", 0));
    std::size_t line = 1;
    for (const char c : lua.substr(0, lua.find("G1{"))) line += c == '\n' ? 1 : 0;
    EXPECT_EQ(line, 3U);
}

TEST(Translation, ReportsErrorAndRejectsProgram) {
    TranslationRequest request;
    request.text = Text("G0 X1\nG1 Y F100\nM2\n", "part.nc");
    auto translation = Translation::open(std::move(request)).value();
    std::vector<Diagnostic> reported;
    const auto result = translation.make([&](const Diagnostic& found) { reported.push_back(found); });
    ASSERT_FALSE(result);
    EXPECT_TRUE(result.error().in_program);
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported.front().line, 2U);
    EXPECT_EQ(result.error().first_error->text, reported.front().text);
}

TEST(Translation, ScriptHasCycleTimeOfProgram) {
    const std::string program = "G0 X10 Y5\nG1 X60 F600\nG3 X60 Y25 I0 J10\nM2\n";
    TranslationRequest request;
    request.text = Text(program, "part.nc");
    Request run = make_request("part.nc", {{"part.nc", program}, {"part.lua", lua_of(request)}});
    const auto time_s = [](const Request& of) {
        engine::Run result = engine::Run::open(of).value();
        EXPECT_TRUE(result.prepare());
        return result.go().value().cycle_time_s;
    };
    const double direct_s = time_s(run);
    run.program = "part.lua";
    EXPECT_EQ(time_s(run), direct_s);
}

}  // namespace
}  // namespace gsim::engine::translation_test
