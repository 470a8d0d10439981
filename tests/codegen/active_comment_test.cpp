// Comments of RS274/NGC with an effect, and the quoting of texts: none may end its string.
#include "codegen/blocks/active_comment.h"

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "codegen/lua/lua_text.h"
#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::active_comment_test {
namespace {

std::string lua(const std::string& comment) {
    return ngc_lua_of("(" + comment + ")");
}

TEST(ActiveComments, BecomeLuaCalls) {
    EXPECT_EQ(lua("MSG,hello"), "MSG(\"hello\")");
    EXPECT_EQ(lua("msg, hello "), "MSG(\" hello \")") << "blanks belong to the text";
    EXPECT_EQ(lua(" debug,x"), "DEBUG(\"x\")");
    EXPECT_EQ(lua("Print,x"), "PRINT(\"x\")");
    EXPECT_EQ(lua("LOG,x"), "LOG(\"x\")");
    EXPECT_EQ(lua("LOGOPEN,file.txt"), "LOGOPEN(\"file.txt\")");
    EXPECT_EQ(lua("LOGAPPEND,file.txt"), "LOGAPPEND(\"file.txt\")");
    EXPECT_EQ(lua("LOGCLOSE"), "LOGCLOSE()");
    EXPECT_EQ(lua("PROBEOPEN probe.txt"), "PROBEOPEN(\"probe.txt\")");
    EXPECT_EQ(lua("PROBECLOSE"), "PROBECLOSE()");
    EXPECT_EQ(lua("MSG,"), "MSG(\"\")");
    EXPECT_EQ(lua("abort,no #5"), "ABORT(\"no %f\", v[5])");
    EXPECT_EQ(lua("py,x=#1"), "PY(\"x=#1\")");
    EXPECT_EQ(lua("PYRUN,file.py"), "PYRUN(\"file.py\")");
    EXPECT_EQ(lua("PyReload"), "PYRELOAD()");
}

/// As LinuxCNC separates them.
TEST(ActiveComments, OrdinaryCommentsProduceNoLua) {
    for (const char* comment :
         {"", "a note", "MSG", "MSG hello", "debug , x", "DEBUGX,#1", "LOGCLOSED", "PROBECLOSE now",
          "abort x", "abort , x", "python", "PYRELOADED", "see MSG,x", "PRINT #1", "LOG #1"})
        EXPECT_EQ(lua(comment), "") << comment;
    EXPECT_EQ(lua_of("(MSG,hello)"), "") << "not in the 9/Series";
}

TEST(ActiveComments, OnlyLastCommentOfBlockActs) {
    EXPECT_EQ(ngc_lua_of("(MSG,a)(MSG,b)"), "MSG(\"b\")");
    EXPECT_EQ(ngc_lua_of("(MSG,a)(note)"), "");
    EXPECT_EQ(ngc_lua_of("(note)(MSG,a)"), "MSG(\"a\")");
    EXPECT_EQ(ngc_lua_of("(MSG,a);note"), "MSG(\"a\")") << "a remark behind ';' is none of them";
    EXPECT_EQ(ngc_lua_of(";MSG,a"), "");
    EXPECT_EQ(ngc_lua_of("X1 ;(MSG,a)"), "move{x=1}");
}

TEST(ActiveComments, ActBeforeTheirBlock) {
    EXPECT_EQ(ngc_lua_of("G1 X1 (MSG,a) F5"), "MSG(\"a\") F(5) G1{x=1}");
    EXPECT_EQ(ngc_lua_of("M2 (MSG,end)"), "MSG(\"end\") M2()");
    EXPECT_EQ(ngc_lua_of("/G1 X1 (MSG,a)"), "if not skipped(1) then MSG(\"a\") G1{x=1} end");
    EXPECT_EQ(ngc_lua_of("/(MSG,a)"), "if not skipped(1) then MSG(\"a\") end");
    EXPECT_EQ(ngc_lua_of("#1=2 (DEBUG,#1)"), "v[1] = 2.0 DEBUG(\"%f\", v[1])") << "the new value";
    EXPECT_EQ(ngc_lua_of("X#1 #1=2 (DEBUG,#1)"),
              "do local w1 = v[1] v[1] = 2.0 DEBUG(\"%f\", v[1]) move{x=w1} end");
}

/// LinuxCNC reads the text after an O-word as part of it.
TEST(ActiveComments, HaveNoEffectAfterOWord) {
    const Translated result =
        translated_ngc("o1 if [1] (MSG,a)\n(MSG,b)\no1 endif (MSG,c)\nO12 (MSG,d)\nM2\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(result.code(1), "if truth(1.0) then");
    EXPECT_EQ(result.code(2), "MSG(\"b\")");
    EXPECT_EQ(result.code(3), "end");
    EXPECT_EQ(result.code(4), "end) program(12, function()");
}

/// Comments may read the position at all times, expressions not while cutter compensation is on.
TEST(ActiveComments, PositionNumbersBecomeNamedParameters) {
    EXPECT_EQ(lua("PRINT,#5420 #5428"), "PRINT(\"%f %f\", parameter(\"_x\"), parameter(\"_w\"))");
    EXPECT_EQ(lua("PRINT,#5419 #5429"), "PRINT(\"%f %f\", v[5419], v[5429])");
}

TEST(ActiveComments, PassParametersAsValues) {
    EXPECT_EQ(lua("DEBUG,a #1 b #<Na me>"), "DEBUG(\"a %f b %f\", v[1], parameter(\"name\"))");
    EXPECT_EQ(lua("DEBUG,#01#02"), "DEBUG(\"%f%f\", v[1], v[2])");
    EXPECT_EQ(lua("DEBUG,#5601 #5602 #0 #99999999999999999999"),
              "DEBUG(\"%f %f %f %f\", v[5601], parameter(\"\"), parameter(\"\"), parameter(\"\"))")
        << "numbers that no parameter has";
    EXPECT_EQ(lua("PRINT,# #- #a #< #<a ##1"), "PRINT(\"# #- #a #< #<a #%f\", v[1])");
    EXPECT_EQ(lua("LOG,#<\">"), "LOG(\"%f\", parameter(\"\\\"\"))");
    EXPECT_EQ(lua("MSG,#1 %d"), "MSG(\"#1 %d\")") << "MSG shows its text as it stands";
}

TEST(ActiveComments, FormatAppliesToAllLaterValues) {
    EXPECT_EQ(lua("DEBUG,%d#1 #2 %.3f#3 %f#4"), "DEBUG(\"%.0f %.0f %.3f %.4f\", v[1], v[2], v[3], v[4])")
        << "a format holds for all values behind it";
    EXPECT_EQ(lua("DEBUG,100% %s %x %.10f %.f %5.3f %n"), "DEBUG(\"100%% %%s %%x %%.10f %%.f %%5.3f %%n\")");
    EXPECT_EQ(lua("DEBUG,%"), "DEBUG(\"%%\")");
    EXPECT_EQ(lua("DEBUG,%."), "DEBUG(\"%%.\")");
}

TEST(ActiveComments, RejectMoreThan50Values) {
    std::string values;
    for (int i = 1; i <= 50; ++i) values += fmt::format("#{}", i);
    EXPECT_EQ(compile_error(translated_ngc("(DEBUG," + values + ")\n").lua), std::nullopt);
    EXPECT_EQ(lua("DEBUG," + values + "#<x>"), "1:1: error: a comment can print at most 50 values\n");
    std::string many = "DEBUG,";
    for (int i = 0; i < 20000; ++i) many += "#1";
    EXPECT_EQ(lua(many), "1:1: error: a comment can print at most 50 values\n");
}

/// Texts of all bytes that a comment can hold: the Lua must compile and hold no other statement.
TEST(ActiveComments, TextCannotEndLuaString) {
    for (const std::string text :
         {"\"", "\\", "\\\"", "\" .. os.exit{1} .. \"", "\\\\\"", "]]", "--", "\r", "\x1b[2J", "\\z",
          "\xff\xfe", "\\x", "\\10", "%\"d", "#<\\>", "#<\" .. x .. \">"}) {
        for (const char* name : {"MSG", "DEBUG", "PRINT", "LOG", "LOGOPEN"}) {
            const Translated result = translated_ngc(fmt::format("({},{})\n", name, text));
            ASSERT_TRUE(result.ok) << text << result.messages;
            EXPECT_EQ(compile_error(result.lua), std::nullopt) << result.lua;
        }
    }
    std::mt19937 random(3);
    constexpr std::string_view kPieces = "\"\\'#%<>[]=-x1n\n .,fd;\r\t";
    for (int i = 0; i < 2000; ++i) {
        std::string text = "(DEBUG,";
        for (std::size_t n = random() % 30; n > 0; --n) {
            const char c = kPieces[random() % kPieces.size()];
            if (c != '\n') text += c;
        }
        const Translated result = translated_ngc(text + ")\n");
        ASSERT_TRUE(result.ok) << text << result.messages;
        ASSERT_EQ(compile_error(result.lua), std::nullopt) << text << "\n" << result.lua;
        ASSERT_EQ(result.lua.find("DEBUG(\""), result.lua.find('\n') + 1) << text << "\n" << result.lua;
    }
}

TEST(LuaText, ChecksNamesAndEscapesStrings) {
    for (const char* name : {"a", "_a", "A9", "width", "endif", "_ENV"})
        EXPECT_TRUE(is_lua_name(name)) << name;
    for (const char* name : {"", "9a", "end", "goto", "not", "nil", "a-b", "a.b", "a b", "\xc3\xa4"})
        EXPECT_FALSE(is_lua_name(name)) << name;
    std::string out;
    write_lua_string(std::string_view("a\"\\\n\r\0\x7f\xe4z", 9), out);
    EXPECT_EQ(out, "\"a\\\"\\\\\\x0A\\x0D\\x00\\x7F\\xE4z\"");
}

TEST(LuaText, QuotesParameterNamesInvalidInLua) {
    EXPECT_EQ(ngc_lua_of("#<end>=1 X#<2nd edge> Y#<_a> Z#<a-b>"),
              "do local w1, w2, w3 = p[\"2ndedge\"], p._a, p[\"a-b\"] p[\"end\"] = 1.0 "
              "move{x=w1, y=w2, z=w3} end");
    EXPECT_EQ(ngc_lua_of("#<a\"]b\\>=1"), "p[\"a\\\"]b\\\\\"] = 1.0");
    EXPECT_EQ(ngc_lua_of("#1=exists[#<a\"b>]"), "v[1] = exists(\"a\\\"b\")");
}

}  // namespace
}  // namespace gsim::codegen::active_comment_test
