// The effect of a script depends on the script alone: the orders, texts and sorts that Lua leaves to its
// hashes and addresses.

#include "tests/lua_lib/run.h"

namespace gsim::script::repeatable_test {
namespace {

TEST(RepeatableScripts, PairsFollowsKeyOrder) {
    const Outcome r = run_lua(R"(
local t = {}
for _, key in ipairs{"zeta", "alpha", "b", "B", "beta"} do t[key] = true end
local first, second = {}, {}
t[second], t[first], t[print] = true, true, true
t[3.5], t[-2], t[7], t[1 << 53], t[(1 << 53) + 1], t[true], t[false] = 1, 1, 1, 1, 1, 1, 1
local order = {}
for key, value in pairs(t) do
  assert(t[key] == value)
  order[#order + 1] = type(key) == "table" and (key == first and "first" or "second") or type(key) == "function" and "f" or tostring(key)
end
local text = table.concat(order, " ")
assert(text == "-2 3.5 7 9007199254740992 9007199254740993 B alpha b beta zeta false true first second f", text)
)");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(RepeatableScripts, NextFollowsKeyOrder) {
    const Outcome r = run_lua(R"(
local t = {c = 3, a = 1, b = 2}
assert(next(t) == "a" and next(t, "a") == "b" and next(t, "b") == "c" and next(t, "c") == nil)
assert(select(2, next(t)) == 1 and next({}) == nil and select("#", next({})) == 1)
local order = ""
for key in next, t do order = order .. key end
assert(order == "abc")
)");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(RepeatableScripts, TableMayChangeDuringIteration) {
    const Outcome r = run_lua(R"(
local t, list = {}, {}
for i = 1, 100 do t["k" .. i], list[i] = i, i end
local seen = 0
for key in pairs(t) do t[key], t["n" .. key], seen = nil, 1, seen + 1 end
assert(seen == 100)
for i in pairs(list) do list[i], list[i + 1] = nil, nil end
assert(next(list) == nil)
)");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(RepeatableScripts, RejectKeysWithoutOrder) {
    const Outcome r = run_lua("local t = {[print] = 1, [pairs] = 2}\nfor k in pairs(t) do end\n");
    expect_alarm(r, 2, {"several functions or userdata as keys", "in a list"});
    expect_alarm(run_lua("local t = {[print] = 1, [pairs] = 2}\nlocal k = next(t)\n"), 2, {"as keys"});
}

TEST(RepeatableScripts, ObjectsHaveNumbersInsteadOfAddresses) {
    const Outcome r = run_lua(R"(
local t, u = {}, {}
assert(tostring(u) == "table: 1" and tostring(t) == "table: 2" and tostring(u) == "table: 1")
assert(("%s %5s|%-9s|%%%d"):format(t, "x", print, 3) == "table: 2     x|function: 3|%3")
assert(not pcall(string.format, "%p", t))
)");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(RepeatableScripts, SortIsStable) {
    const Outcome r = run_lua(R"(
local t = {}
for i = 1, 500 do t[i] = {key = i % 7, at = i} end
table.sort(t, function(a, b) return a.key < b.key end)
for i = 2, 500 do assert(t[i - 1].key < t[i].key or t[i - 1].key == t[i].key and t[i - 1].at < t[i].at) end
local words = {"b", "a", "C", "a"}
table.sort(words)
assert(table.concat(words) == "Caab")
assert(not pcall(table.sort, {1, "x"}) and not pcall(table.sort, {1, 2}, 5))
)");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(RepeatableScripts, SortEndsWithAnyComparison) {
    for (const char* compare :
         {"return true", "return false", "return math.random() < 0.5", "return a ~= b"}) {
        const Outcome r = run_lua(std::string("local t = {} for i = 1, 999 do t[i] = i end\n"
                                              "table.sort(t, function(a, b) ") +
                                  compare +
                                  " end)\nlocal sum = 0 for i = 1, 999 do sum = sum + t[i] end\n"
                                  "assert(#t == 999 and sum == 999 * 500)");
        EXPECT_TRUE(r.completed()) << compare << ": " << r.message();
    }
}

TEST(RepeatableScripts, ReportAlphabeticallyFirstWrongWord) {
    const char* words = "{x=1, zulu=1, mike=1, alpha=1, kilo=1, yankee=1}";
    for (const char* word : {"G0", "G1", "G2", "G28", "MoveLinear"})
        expect_alarm(run_lua(std::string("F(100)\n") + word + words), 2, {"'alpha'"});
    expect_alarm(run_lua("G0{x=0/0, y=0/0, z=0/0, b=0/0}"), 1, {"the value of B is not a number"});
}

}  // namespace
}  // namespace gsim::script::repeatable_test
