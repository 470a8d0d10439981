// The same script gives the same output in each process, though Lua's hashes and all addresses differ.

#include "tests/apps/run_program.h"

namespace gsim::apps::repeatable_test {
namespace {

using Repeatability = Apps;

constexpr const char* kScript = R"(
local t = {}
for i = 1, 200 do t["key" .. (i * 7919 % 1000)] = i end
for i = 1, 20 do t[{}] = i end
t[print] = "f"
for key, value in pairs(t) do print(key, value) end
print(next(t), t, print, {}, string.format("%s", t))
local list = {}
for i = 1, 500 do list[i] = {key = i % 3, at = i} end
table.sort(list, function(a, b) return a.key < b.key end)
for _, each in ipairs(list) do print(each.at) end
print(pcall(error, {}), math.random(1000))
for _, f in ipairs{print, pairs, next, tostring, string.rep, string.find, table.sort, math.floor, G0, require} do print(pcall(f)) end
G0{x=1, november=1, charlie=1, zulu=1, mike=1, kilo=1}
)";

TEST_F(Repeatability, GivesSameOutputInEachProcess) {
    write("part.lua", kScript);
    const Ended first = gsim_run({"part.lua", "--json"});
    EXPECT_EQ(first.status, 1);
    EXPECT_TRUE(contains(first.out, "'charlie'")) << first.out;
    for (int i = 0; i < 8; ++i) {
        const Ended repeated = gsim_run({"part.lua", "--json"});
        EXPECT_EQ(repeated.err, first.err);
        EXPECT_EQ(repeated.out, first.out);
    }
}

}  // namespace
}  // namespace gsim::apps::repeatable_test
