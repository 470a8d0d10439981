// Lines of plain calls mean what Lua makes of them.
#include "runtime/script/lua/plain_calls.h"

#include <memory>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <lua.hpp>

namespace gsim::script::plain_calls_test {
namespace {

struct Closer {
    void operator()(lua_State* lua) const { lua_close(lua); }
};

std::string reported(const PlainCall::Number& number) {
    if (const auto* integer = std::get_if<lua_Integer>(&number)) return fmt::format("integer {}", *integer);
    return fmt::format("float {:a}", std::get<lua_Number>(number));
}

std::string reported(lua_State* lua, int index) {
    if (lua_isinteger(lua, index) != 0) return fmt::format("integer {}", lua_tointeger(lua, index));
    return fmt::format("float {:a}", lua_tonumber(lua, index));
}

// Records the call of any word.
int note(lua_State* lua) {
    auto& notes = *static_cast<std::string*>(lua_touserdata(lua, lua_upvalueindex(1)));
    notes += lua_tostring(lua, lua_upvalueindex(2));
    if (lua_istable(lua, 1)) {
        for (const char* key : {"a", "b", "x", "y", "rate"}) {
            lua_getfield(lua, 1, key);
            if (!lua_isnil(lua, -1)) notes += fmt::format(" {}={}", key, reported(lua, -1));
            lua_pop(lua, 1);
        }
    } else if (lua_gettop(lua) > 0) {
        notes += " " + reported(lua, 1);
    }
    notes += ";";
    return 0;
}

int find_word(lua_State* lua) {
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_pushvalue(lua, 2);
    lua_pushcclosure(lua, note, 2);
    return 1;
}

// Returns the calls of a line as Lua makes them, or "error" if it does not compile.
std::string by_lua(const std::string& line) {
    const std::unique_ptr<lua_State, Closer> lua(luaL_newstate());
    std::string notes;
    lua_pushglobaltable(lua.get());
    lua_newtable(lua.get());
    lua_pushlightuserdata(lua.get(), &notes);
    lua_pushcclosure(lua.get(), find_word, 1);
    lua_setfield(lua.get(), -2, "__index");
    lua_setmetatable(lua.get(), -2);
    const bool ran =
        luaL_loadstring(lua.get(), line.c_str()) == LUA_OK && lua_pcall(lua.get(), 0, 0, 0) == LUA_OK;
    return ran ? notes : "error";
}

// Returns the same as they are read, or "no" if the line is not plain.
std::string as_read(const std::string& line) {
    PlainLine reader;
    if (!reader.read(line)) return "no";
    std::string notes;
    for (const PlainCall& call : reader.calls()) {
        notes += call.word;
        if (call.argument) notes += " " + reported(*call.argument);
        for (const std::string_view key : {"a", "b", "x", "y", "rate"}) {
            const PlainCall::Field* found = nullptr;  // of one key twice the last one counts
            for (const PlainCall::Field& field : call.fields())
                if (field.key == key) found = &field;
            if (found != nullptr) notes += fmt::format(" {}={}", key, reported(found->value));
        }
        notes += ";";
    }
    return notes;
}

TEST(PlainCalls, LinesOfTranslatorEqualLua) {
    EXPECT_EQ(as_read("F(3000) G1{x=5.000, y=-2} M8()   -- N20 (go)"),
              "F integer 3000;G1 x=float 0x1.4p+2 y=integer -2;M8;");
    for (const char* line : {"",
                             "   ",
                             "-- only a comment",
                             "M8()",
                             "G1{}",
                             "G1{ }",
                             "F(3000)",
                             "F(-0)",
                             "F(-0.0)",
                             "F(0.1)",
                             "F(.5)",
                             "F(5.)",
                             "F(00012)",
                             "G1{x=1, x=2}",
                             "G1{x=1,y=2,rate=0.30000000000000004}",
                             "G1{x=123456789012345678.5}",
                             "F(9223372036854775807)",
                             "G0{a=-9223372036854775808.0}",
                             "M3() S(100) G4{x=2.5}  --",
                             "_x1(3)",
                             "F(0.000000000000000000000000000000000000000000000001)"}) {
        EXPECT_NE(as_read(line), "no") << line;
        EXPECT_EQ(as_read(line), by_lua(line)) << line;
    }
}

TEST(PlainCalls, LeavesOtherLinesToLua) {
    for (const char* line : {"x = 1",
                             "G1{x=v[1]}",
                             "G1{x=1+1}",
                             "G1{x=1e3}",
                             "F(0x10)",
                             "F(9223372036854775808)",
                             "F(1..2)",
                             "F(1.2.3)",
                             "F()()",
                             "F(1, 2)",
                             "F 'a'",
                             "M8() return 1",
                             "do return (M99()) end",
                             "::N5:: M8()",
                             "G1{1}",
                             "G1{x=1; y=2}",
                             "G1{x=1,}",
                             "G1{x=}",
                             "G1{x",
                             "G1{x=1",
                             "G1{x=1,",
                             "F(",
                             "F(-",
                             "F(--)",
                             "F(-)",
                             "F(.)",
                             "F",
                             "F (3)",
                             "M8(); M9()",
                             "a.b()",
                             "a:b()",
                             "F(1)--[[ M8()",
                             "--[[",
                             "--[==[ x",
                             "F(1)\t",
                             "M8()\r",
                             "F(1) (2)",
                             "F(- 5)",
                             "1()",
                             "F(5f)",
                             "F(5_)",
                             "G1{a=1,b=1,c=1,d=1,e=1,f=1,g=1,h=1,i=1,j=1,k=1,l=1,m=1,n=1,o=1,p=1,q=1}"})
        EXPECT_EQ(as_read(line), "no") << line;
    EXPECT_EQ(as_read(std::string("F(1)\0", 5)), "no");
}

std::string random_line(std::mt19937& random) {
    constexpr std::string_view kPieces[] = {
        "F",    "G1",      "(",     ")",     "{",   "}",      "x=",
        "y=",   "rate=",   "1",     "-",     "2.",  ".5",     "07",
        "3.25", ", ",      " ",     "()",    "--",  "--[",    "{}",
        "1e2",  "G1{x=1}", "F(-2)", "M8() ", "a=0", "b=-0.0", "9223372036854775808"};
    std::string line;
    for (auto i = 1 + random() % 9; i > 0; --i) line += kPieces[random() % std::size(kPieces)];
    return line;
}

TEST(PlainCalls, RandomLinesEqualLua) {
    std::mt19937 random(14);
    int plain = 0;
    for (int i = 0; i < 60'000; ++i) {
        const std::string line = random_line(random);
        const std::string read = as_read(line);
        if (read == "no") continue;
        ++plain;
        ASSERT_EQ(read, by_lua(line)) << line;
    }
    EXPECT_GT(plain, 1000);
}

}  // namespace
}  // namespace gsim::script::plain_calls_test
