// The text of a script: comments that cannot end themselves, the first line, the hash in it.
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::script_text_test {
namespace {

std::string line(const std::string& lua, int number) {
    std::size_t begin = 0;
    for (int i = 1; i < number; ++i) begin = lua.find('\n', begin) + 1;
    return lua.substr(begin, lua.find('\n', begin) - begin);
}

TEST(Comments, FollowLuaCode) {
    const std::string lua = translated("O0007 (main)\nN0010 G1 X5 (one) (two)\n\n(alone)\n").lua;
    EXPECT_EQ(line(lua, 2), "program(7, function()                                   -- O0007 (main)");
    EXPECT_EQ(line(lua, 3), "G1{x=5}                                                 -- N10 (one) (two)");
    EXPECT_EQ(line(lua, 4), "");
    EXPECT_EQ(line(lua, 5), "                                                        -- (alone)");
}

TEST(Comments, CannotEndTheirLineOrBecomeCode) {
    const char* const comments[] = {"a\rb", "--[[ never closed", "]] error'x'", "a\x1b[2J", "\x7f", "[==[",
                                    "\\n",  "\xff\xfe"};
    for (const std::string comment : comments) {
        for (const bool annotate : {false, true}) {
            TranslateOptions options;
            options.annotate = annotate;
            const Translated result = translated("(" + comment + ")\n(" + comment + ") X1\nY2\n", options);
            ASSERT_TRUE(result.ok) << result.messages;
            EXPECT_EQ(compile_error(result.lua), std::nullopt) << result.lua;
            EXPECT_EQ(result.code(3), "move{y=2}") << comment;
            EXPECT_EQ(std::count(result.lua.begin(), result.lua.end(), '\r'), 0) << comment;
            EXPECT_EQ(std::count(result.lua.begin(), result.lua.end(), '\x1b'), 0) << comment;
        }
    }
    EXPECT_NE(translated("(a\rb)\n").lua.find("-- (a\\x0Db)"), std::string::npos);
}

TEST(Comments, AnnotateOptionAddsFullBlock) {
    TranslateOptions options;
    options.annotate = true;
    const std::string lua = translated("  N5 g1 x5 (go)  \r\nO2 M99\nX1;Y2\n", options).lua;
    EXPECT_EQ(line(lua, 2), "G1{x=5}                                                 -- N5 g1 x5 (go)");
    EXPECT_EQ(line(lua, 3), "end) program(2, function() do return (M99()) end        -- O2 M99");
    EXPECT_EQ(line(lua, 4), "move{x=1} move{y=2}                                     -- X1; Y2");
}

TEST(FirstLine, NamesFileWithoutFolder) {
    TranslateOptions options;
    options.source_name = "some/folder/part.nc";
    const TextTranslation result = translate_text("O1\n", options);
    EXPECT_EQ(result.lua.substr(0, result.lua.find("; hash")),
              "local _ENV = require \"gsim\" -- from part.nc; line n there is line n+1 here");
    options.source_name = "part.nc";
    EXPECT_EQ(translate_text("O1\n", options).lua, result.lua);
}

TEST(FirstLine, StaysValidWithUnusualFileNames) {
    for (const std::string name :
         {"a\nb.nc", "a\rb.nc", "; hash 0", "x; line n there is line n+1 here", "]]--[["}) {
        TranslateOptions options;
        options.source_name = name;
        const TextTranslation result = translate_text("X1\n", options);
        ASSERT_TRUE(result.ok);
        EXPECT_EQ(compile_error(result.lua), std::nullopt) << result.lua;
        EXPECT_EQ(std::count(result.lua.begin(), result.lua.end(), '\n'), 3) << result.lua;
        EXPECT_TRUE(script_origin(result.lua).unedited) << result.lua;
    }
}

TEST(Origin, DetectsEditedScript) {
    const std::string lua = translated("O1\nG1 X5\nM2\n").lua;
    EXPECT_EQ(script_origin(lua).source_name, "part.nc");
    EXPECT_TRUE(script_origin(lua).unedited);
    for (std::size_t i = lua.find('\n') + 1; i < lua.size(); ++i) {
        std::string edited = lua;
        edited[i] = edited[i] == 'x' ? 'y' : 'x';
        EXPECT_FALSE(script_origin(edited).unedited) << "byte " << i;
        EXPECT_EQ(script_origin(edited).source_name, "part.nc");
    }
    EXPECT_FALSE(script_origin(lua + "\n").unedited);
    EXPECT_FALSE(script_origin(lua.substr(0, lua.size() - 1)).unedited);
}

TEST(Origin, IsUnknownForUntranslatedScript) {
    for (const std::string lua : {"", "\n", "print(1)", "-- from here\nG1{x=1}\n", "x = '; hash 0'\n"}) {
        EXPECT_EQ(script_origin(lua).source_name, "") << lua;
        EXPECT_FALSE(script_origin(lua).unedited) << lua;
    }
}

TEST(Hash, IsIndependentOfChunkSize) {
    std::string text;
    for (int i = 0; i < 300; ++i) text += static_cast<char>(i * 7);
    TextHash full;
    full.update(text);
    for (std::size_t step = 1; step < 40; ++step) {
        TextHash parts;
        for (std::size_t i = 0; i < text.size(); i += step)
            parts.update(std::string_view(text).substr(i, step));
        EXPECT_EQ(parts.value(), full.value()) << step;
    }
    TextHash longer;
    longer.update(text + '\0');
    EXPECT_NE(longer.value(), full.value());
}

TEST(Spool, KeepsBigScriptUnchanged) {
    std::string gcode;
    for (int i = 0; i < 20000; ++i) gcode += fmt::format("X{}\n", i);
    const Translated result = translated(gcode);
    ASSERT_TRUE(result.ok);
    EXPECT_EQ(result.code(20000), "move{x=19999}");
    EXPECT_TRUE(script_origin(result.lua).unedited);
}

}  // namespace
}  // namespace gsim::codegen::script_text_test
