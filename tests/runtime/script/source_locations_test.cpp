// Line of a message, and runs that are independent of each other.

#include "codegen/lua/lua_spool.h"
#include "codegen/translate.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::places_test {
namespace {

TEST(SourceLocations, RecognizeUneditedLuaOfGCode) {
    const codegen::TextTranslation translation = codegen::translate_text("G0 X1\n\nG0 X5000\n", {});
    const codegen::ScriptOrigin origin = codegen::script_origin(translation.lua);
    EXPECT_TRUE(origin.unedited);
    EXPECT_EQ(origin.source_name, "part.nc");
    std::string edited = translation.lua;
    edited.replace(edited.find("5000"), 4, "6000");
    EXPECT_FALSE(codegen::script_origin(edited).unedited);
    expect_alarm(run_lua(edited), 4, {"6000"});  // the line of the Lua
}

TEST(SourceLocations, LuaErrorsHaveLine) {
    expect_alarm(run_lua("\n\nlocal x = {} .. 5\n"), 3, {"concatenate"});
    expect_alarm(run_lua("\nG0{x=1\n\nG0{y=}\n"), 4, {});
    expect_alarm(run_lua("function f()\nerror(\"mine\")\nend\nf()\n"), 2, {"mine"});
    expect_alarm(run_lua("function f()\nG0{x=9999}\nend\n\nf()\n"), 2, {"axis X"});
    const Outcome r = run_lua("\n\nlocal x = {} .. 5\n");
    EXPECT_EQ(r.message().find("#0"), std::string::npos) << r.message();
    EXPECT_EQ(r.report.source.files.at(r.report.alarm->location.file), "part.lua");
}

TEST(SourceLocations, TailCallErrorHasValidLine) {
    const Outcome r = run_lua("local function f() return G0{x=9999} end\nf()\n");
    EXPECT_EQ(r.report.status, simulation::RunStatus::alarm);
    EXPECT_GE(r.line(), 1U);
    EXPECT_LE(r.line(), 2U);
}

TEST(SourceLocations, StepLimitErrorHasLineOfLoop) {
    Conditions conditions;
    conditions.options.limits.steps = 100'000;
    const Outcome r = run_lua("G0{x=1}\nG0{x=2}\nwhile true do\nend\n", conditions);
    expect_stopped(r, "--max-steps");
    EXPECT_GE(r.line(), 3U);
}

TEST(Simulators, RunIndependentlyInOneProcess) {
    simulation::Simulator first(built_in_machine(), {});
    simulation::Simulator second(built_in_machine(), {});
    Engine one(first, {});
    Engine other(second, {});
    EXPECT_TRUE(one.run(Script::from_text("G91() v[1] = 5.0 shared = 7 G0{x=100}", "a.lua", 0)));
    EXPECT_FALSE(other.run(Script::from_text("G0{x=10.0, y=v[1]} G0{z=shared}", "b.lua", 0)));
    EXPECT_NE(second.outcome().alarm()->message.find("'shared'"), std::string::npos);
    EXPECT_FALSE(first.outcome().alarm());
    EXPECT_DOUBLE_EQ(first.position().axes()[0], 100);
    EXPECT_DOUBLE_EQ(second.position().axes()[0], 10);
    EXPECT_DOUBLE_EQ(second.position().axes()[1], 0);  // #1 is vacant there
}

}  // namespace
}  // namespace gsim::script::places_test
