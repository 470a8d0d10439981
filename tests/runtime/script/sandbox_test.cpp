// A script is somebody's file: what it cannot see, what it cannot catch, and what it cannot use up.

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::sandbox_test {
namespace {

// Tight limits, so that what runs against them does so at once.
Conditions tight() {
    Conditions conditions;
    conditions.options.limits.memory_bytes = std::size_t{32} << 20U;
    conditions.options.limits.steps = 2'000'000;
    return conditions;
}

Conditions little_memory() {
    Conditions conditions;
    conditions.options.limits.memory_bytes = std::size_t{32} << 20U;
    return conditions;
}

TEST(Sandbox, HidesUnsafeFunctions) {
    for (const char* name :
         {"io",       "os",        "load",           "loadstring",   "loadfile",     "dofile", "debug",
          "package",  "coroutine", "collectgarbage", "setmetatable", "getmetatable", "rawget", "rawset",
          "rawequal", "rawlen",    "xpcall",         "_G",           "utf8",         "core",   "include",
          "env",      "word"}) {
        const Outcome r = run_lua(fmt::format("local x = {}\n", name));
        expect_alarm(r, 1, {fmt::format("'{}'", name)});
    }
}

TEST(Sandbox, StringsHaveNoPatternsAndNoBytecode) {
    for (const char* name : {"match", "gmatch", "gsub", "dump", "pack", "unpack", "packsize"}) {
        const Outcome r = run_lua(fmt::format("assert(string.{0} == nil and (\"\").{0} == nil)", name));
        EXPECT_TRUE(r.completed()) << name << r.message();
    }
    EXPECT_TRUE(run_lua("assert((\"a.c\"):find(\".\") == 2)").completed());  // a plain search
    EXPECT_TRUE(run_lua("assert((\"abc\"):find(\"z\") == nil)").completed());
    EXPECT_TRUE(
        run_lua("assert((\"abc\"):find(\"a\", -5) == 1 and (\"abc\"):find(\"a\", 9) == nil)").completed());
}

TEST(Sandbox, OffersBasicLibraryFunctions) {
    const Outcome r = run_lua(R"(
assert(math.floor(2.5) == 2 and math.pi > 3 and ("ab"):upper() == "AB" and ("x"):rep(3) == "xxx")
local t = {3, 1, 2}
table.sort(t)
assert(table.concat(t, ",") == "1,2,3" and select("#", table.unpack(t)) == 3)
assert(pcall(error, "mine") == false and tostring(1.5) == "1.5" and type(next) == "function")
assert(math.random() == math.random() or true)
)");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(Sandbox, RandomNumbersRepeatInEachRun) {
    const char* script = "G0{x=math.random(1, 1000), y=math.random() * 1000}";
    EXPECT_EQ(run_lua(script).end(), run_lua(script).end());
}

TEST(Sandbox, RequireFindsOnlyBuiltInModules) {
    EXPECT_TRUE(run_lua("local _ENV = require \"gsim\"\nG0{x=1}").completed());
    for (const char* name : {"io", "os", "/etc/passwd", "", "package"})
        expect_alarm(run_lua(fmt::format("local _ENV = require \"gsim\"\nlocal m = require \"{}\"", name)), 2,
                     {fmt::format("require \"{}\": this run has no module folder", name)});
    expect_alarm(
        run_lua("local m = require \"gsim.core\""), 1,
        {"require \"gsim.core\": the library has only \"gsim\", \"gsim.rs274ngc\" and \"gsim.klipper\""});
    EXPECT_TRUE(run_lua("assert(require \"math\" == math and require \"rrs\" == rrs)").completed());
    EXPECT_EQ(run_lua("require()").report.status, simulation::RunStatus::alarm);
    expect_alarm(run_lua("local _ENV = require \"gsim.rs274ngc\""), 1,
                 {"dialect ab9", "\"gsim.rs274ngc\" is of another dialect"});
}

TEST(Sandbox, RejectsBytecode) {
    const Outcome r = run_lua(std::string_view("\x1bLuaT\0\x19\x93\r\n\x1a\n", 12));
    EXPECT_EQ(r.report.status, simulation::RunStatus::alarm);
    EXPECT_NE(r.message().find("binary"), std::string::npos) << r.message();
}

TEST(Sandbox, PcallCatchesScriptErrors) {
    const Outcome r = run_lua(R"(
local ok, message = pcall(function() error("mine") end)
assert(not ok)
assert(not pcall(function() return undefined_name end))
assert(select(2, pcall(error, {code = 5})).code == 5)
assert(select("#", pcall(function() return 1, nil, 3 end)) == 4)
G0{x=5}
)");
    expect_end(r, 5, 0, 0);
}

TEST(Sandbox, PcallDoesNotCatchAlarm) {
    const Outcome r = run_lua("pcall(function() G0{x=9999} end)\nG0{x=5}\n");
    expect_alarm(r, 1, {"axis X", "9999"});
    EXPECT_TRUE(r.moves.empty());
    const Outcome nested = run_lua("pcall(pcall, pcall, function() G0{x=9999} end)\nG0{x=5}\n");
    expect_alarm(nested, 1, {"axis X"});
    EXPECT_TRUE(nested.moves.empty());
    const Outcome sorted = run_lua("pcall(table.sort, {1, 2, 3}, function() G0{x=9999} end)\nG0{x=5}\n");
    expect_alarm(sorted, 1, {"axis X"});
    EXPECT_TRUE(sorted.moves.empty());
}

TEST(Sandbox, PcallDoesNotCatchProgramEnd) {
    expect_end(run_lua("G0{x=1}\npcall(M2)\nG0{x=5}\n"), 1, 0, 0);
}

TEST(Sandbox, StopsEndlessLoops) {
    expect_stopped(run_lua("while true do end", tight()), "--max-steps");
    expect_stopped(run_lua("for i = 1, math.huge do local x = i end", tight()), "--max-steps");
    expect_stopped(run_lua("while true do pcall(function() while true do end end) end", tight()),
                   "--max-steps");
    expect_stopped(run_lua("local function f() return f() end f()", tight()), "--max-steps");
    expect_stopped(run_lua("table.sort({1, 2, 3}, function() while true do end end)", tight()),
                   "--max-steps");
    expect_stopped(run_lua("G0{x=1}\nwhile true do G0{} end", tight()), "--max-steps");
}

TEST(Sandbox, StepCountRestartsWithEachMotion) {
    Conditions conditions = tight();
    const Outcome r = run_lua("for i = 1, 20 do for j = 1, 100000 do local x = j end G0{x=i} end",
                              conditions);  // at least 4 steps a pass
    expect_end(r, 20, 0, 0);
}

TEST(Sandbox, StopsAtMemoryLimit) {
    expect_stopped(run_lua("local t = {} for i = 1, 1e9 do t[i] = i end", little_memory()), "--memory");
    expect_stopped(run_lua("local s = \"x\" while true do s = s .. s end", little_memory()), "--memory");
    expect_stopped(run_lua("pcall(function() local s = \"x\" while true do s = s .. s end end)\nG0{x=1}",
                           little_memory()),
                   "--memory");
}

TEST(Sandbox, StopsLongStringsAtMemoryLimit) {
    expect_stopped(run_lua("local s = (\"x\"):rep(1 << 30)", little_memory()), "--memory");
    expect_stopped(run_lua("local s = (\"x\"):rep(1 << 10, (\"y\"):rep(1 << 16))", little_memory()),
                   "--memory");
    const Outcome caught = run_lua("pcall(string.rep, \"x\", 1 << 30)\nG0{x=1}", little_memory());
    expect_stopped(caught, "--memory");
    EXPECT_TRUE(caught.moves.empty());
    expect_stopped(
        run_lua("local t = {} for i = 1, 64 do t[i] = (\"x\"):rep(1 << 18) end local s = table.concat(t)",
                little_memory()),
        "--memory");
}

TEST(Sandbox, RepeatsOfEmptyStringEndImmediately) {
    EXPECT_TRUE(run_lua("assert((\"\"):rep(math.maxinteger) == \"\")").completed());
    EXPECT_TRUE(run_lua("assert((\"\"):rep(math.maxinteger, \"\") == \"\")").completed());
    EXPECT_TRUE(run_lua("assert((\"a\"):rep(-1) == \"\" and (\"a\"):rep(2, \",\") == \"a,a\")").completed());
}

TEST(Sandbox, LargeStringsCountAsSteps) {
    Conditions conditions = tight();
    conditions.options.limits.memory_bytes = std::size_t{256} << 20U;
    expect_stopped(
        run_lua("local s = (\"x\"):rep(1 << 24)\nwhile true do local t = s .. \"y\" end", conditions),
        "--max-steps");
    expect_stopped(run_lua("while true do local t = (\"x\"):rep(1 << 24) end", conditions), "--max-steps");
}

TEST(Sandbox, WorkOnLongTablesCountsAsSteps) {
    const std::string table = "local t = {} for i = 1, 100000 do t[i] = \"\" end\n";
    for (const char* call : {"table.insert(t, 1, \"\") table.remove(t, 1)", "table.concat(t)",
                             "table.sort(t)", "table.unpack(t)", "((\"x\"):rep(1 << 20)):find(\"y\")"})
        expect_stopped(run_lua(table + "while true do " + call + " end", tight()), "--max-steps");
    // The end of a table is no work, however long it is.
    EXPECT_TRUE(run_lua("local t = {} for i = 1, 100000 do table.insert(t, i) end").completed());
}

TEST(Sandbox, WorkInsideOneCallCountsAsSteps) {
    Conditions conditions = tight();
    conditions.options.limits.memory_bytes = std::size_t{1024} << 20U;
    const std::string large = "local s = (\"a\"):rep(1 << 22)\n";
    for (const char* call : {"s:find((\"a\"):rep(1 << 12) .. \"b\")", "tonumber(s .. \"x\")", "s:upper()",
                             "s:lower()", "s:reverse()", "(s .. \"a\"):byte(1, 9)", "s:format()"}) {
        SCOPED_TRACE(call);
        expect_stopped(run_lua(large + "for i = 1, 2000 do local x = " + call + " end", conditions),
                       "--max-steps");
    }
    const std::string list = "local t = {} for i = 1, 30000 do t[i * 2] = i end\n";
    for (const char* call : {"pairs(t)", "next(t)", "next(t, 2)"}) {
        SCOPED_TRACE(call);
        expect_stopped(run_lua(list + "for i = 1, 2000 do local x = " + call + " end", tight()),
                       "--max-steps");
    }
}

TEST(Sandbox, InstructionsOnLargeValuesCountBySize) {
    Conditions conditions = tight();
    conditions.options.limits = {.memory_bytes = std::size_t{256} << 20U, .steps = 500'000};
    // Each comparison checks 16 MB, and each call copies 100,000 values.
    expect_stopped(run_lua("local a, b = (\"x\"):rep(1 << 24), (\"x\"):rep(1 << 24)\n"
                           "for i = 1, 40000 do local same = a == b end",
                           conditions),
                   "--max-steps");
    conditions.options.limits.steps = 1'000'000;
    expect_stopped(run_lua("local t = {} for i = 1, 100000 do t[i] = 0 end\n"
                           "local function f() end\n"
                           "local function g(...) for i = 1, 100000 do f(...) end end\n"
                           "g(table.unpack(t))",
                           conditions),
                   "--max-steps");
}

TEST(Sandbox, RangeOfLongTableCostsItsLength) {
    EXPECT_TRUE(run_lua("local t = {} for i = 1, 100000 do t[i] = i end\n"
                        "for i = 1, 10000 do local a, b = table.unpack(t, i, i + 1) end",
                        tight())
                    .completed());
}

TEST(Sandbox, RejectsInvalidRangesAndArguments) {
    for (const char* call :
         {"table.concat({}, \"\", 1, math.maxinteger)", "table.unpack({}, 1, math.maxinteger)",
          "table.unpack({}, math.mininteger, math.maxinteger)", "table.insert({}, 5, 1)",
          "table.insert({}, math.maxinteger, 1)", "string.format(\"%\" .. (\"9\"):rep(50) .. \"d\", 1)",
          "string.char(-1)", "string.byte((\"x\"):rep(1 << 22), 1, -1)", "math.random(0, -1)",
          "math.floor(nil)", "tostring()", "select(-5)"}) {
        const Outcome r = run_lua(std::string("local x = ") + call, tight());
        EXPECT_FALSE(r.completed()) << call;
    }
}

TEST(Sandbox, ReportsDeepRecursion) {
    for (const char* script :
         {"local function f(n) return 1 + f(n + 1) end f(1)", "local function f() pcall(f) return 1 end f()",
          "local function f() table.sort({1, 2}, f) end f()", "local function f() error(f()) end f()"}) {
        const Outcome r = run_lua(script, tight());
        SCOPED_TRACE(script);
        EXPECT_TRUE(r.completed() || !r.message().empty());
    }
    const Outcome r = run_lua("local function f(n) return 1 + f(n + 1) end f(1)");
    expect_alarm(r, 1, {"overflow"});
    std::string nested = "local x = ";
    for (int i = 0; i < 500; ++i) nested += "(";
    EXPECT_EQ(run_lua(nested).report.status, simulation::RunStatus::alarm);
}

TEST(Sandbox, ScriptsCannotChangeLibrary) {
    // The functions of Lua are the script's to change; the library keeps its own copies.
    expect_end(
        run_lua("math.cos = nil math.floor = nil string.format = nil table.sort = nil G16() G0{x=10, y=90}"),
        0, 10, 0);
    expect_alarm(run_lua("string.format = function() return 5 end\nG2{x=10}\n"), 2, {"centre"});
}

TEST(Sandbox, ReportsErrorsOfAnyType) {
    EXPECT_EQ(run_lua("error({})").report.status, simulation::RunStatus::alarm);
    EXPECT_EQ(run_lua("error(nil)").report.status, simulation::RunStatus::alarm);
    EXPECT_EQ(run_lua("error()").report.status, simulation::RunStatus::alarm);
    expect_alarm(run_lua("\nerror(\"plain\", 0)"), 2, {"plain"});
    expect_alarm(run_lua("\nerror(\"#7:9: forged\", 0)"), 2, {});
}

TEST(Sandbox, ReportsBadArgumentsOfWordsAtLine) {
    for (const char* call : {"G0(5)",
                             "G0(\"x\")",
                             "G0{5}",
                             "G0{x=\"a\"}",
                             "G0{x={}}",
                             "G0{q=1}",
                             "G1{i=1}",
                             "G2(5)",
                             "G2{x=1, i={}}",
                             "G2{r={}, x=1}",
                             "G4()",
                             "G4{p={}}",
                             "G4{p=\"s\"}",
                             "F(\"fast\")",
                             "F{}",
                             "S(-1)",
                             "S{}",
                             "T{}",
                             "M98()",
                             "M98{p={}}",
                             "M98{p=1e300}",
                             "M98{p=1, l=1e300}",
                             "G92()",
                             "G92{x={}}",
                             "G92{[5]=1}",
                             "G52{q=1}",
                             "G28(5)",
                             "G27{x={}}",
                             "G29()",
                             "CIP()",
                             "CIP{x=1}",
                             "CIP{x=1, i1={}}",
                             "move(5)",
                             "MoveLinear()",
                             "MoveLinear{x={}}",
                             "MoveLinear{pitch=45, yaw=45}",
                             "MoveLinear{X=5}",
                             "MoveJoint(5)",
                             "MoveCircular{}",
                             "MoveCircular{via={}, to=5}",
                             "program(1)",
                             "v[{}] = 1",
                             "v.x = 1",
                             "v[0/0] = 1",
                             "v[1] = {} G0{x=v[1]}",
                             "G0{x=0/0}",
                             "G0{x=1/0}",
                             "G4{p=1/0}",
                             "G0{x=1e308} G0{x=-1e308}",
                             "D{}",
                             "skipped(5)()",
                             "goto_target({})",
                             "truth({})",
                             "SIN({})",
                             "div(1, {})"}) {
        SCOPED_TRACE(call);
        const Outcome r = run_lua(std::string("F(100)\n") + call + "\nG0{x=5}\n");
        EXPECT_TRUE(r.completed() || r.line() == 2U) << r.message();
        EXPECT_EQ(r.message().find("lua_lib"), std::string::npos) << r.message();
        EXPECT_EQ(r.message().find("#0"), std::string::npos) << r.message();
    }
}

}  // namespace
}  // namespace gsim::script::sandbox_test
