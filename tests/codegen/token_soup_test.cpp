// Random input to the translator in either dialect: it always answers, twice the same, with Lua that compiles
// if it accepts the input.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/random_program.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::token_soup_test {
namespace {

constexpr const char* kShared[] = {
    "G0 ",  "G1",    "G2 ", "G4 ",    "G92 ", "G53 ", "G10 ", "G90 ",    "M2",      "M3 ", "M99 ",
    "M98 ", "M101 ", "X1 ", "X[1+2]", "Y#1 ", "Z-#2", "I1 ",  "P1 ",     "L2 ",     "R3 ", "Q.5 ",
    "F5 ",  "S1",    "T1 ", "H1 ",    "D1 ",  "N5 ",  "/ ",   "#1=2 ",   "#[1]=#2", "(c)", "(MSG,\"\\)",
    "; ",   "[",     "]",   "=",      "+",    "-",    "*",    " AND ",   " EQ ",    "5",   "ATAN[1]/[2] ",
    "\n",   "\n",    "\n",  "\n",     "\r\n", "%\n",  "O1 ",  "SIN[1] ", "##",      "E7",  "\t"};
constexpr const char* kAb9[] = {"IF[#1 EQ 2]",     "GOTO5 ",  "GOTO#1 ", "THEN ", "WHILE[#1]DO1", "END1\n",
                                "DPRNT[#1[53]]\n", "POPEN\n", "PCLOS ",  ",C1 ",  ",R[#1] ",      ",A30 ",
                                "G65 P1 ",         "CIP ",    "I1=5 ",   "AR=9 ", "U1 ",          "#3000=1 ",
                                "M99P5 ",          "\nN5 ",   "OPART\n"};
constexpr const char* kNgc[] = {"\no1 if [1]\n",
                                "\no1 endif\n",
                                "\no1 else\n",
                                "\no2 while [#1]\n",
                                "\no2 endwhile\n",
                                "\no3 sub\n",
                                "\no3 endsub\n",
                                "\no3 call [1]",
                                "\no2 break\n",
                                "\no2 continue\n",
                                "\no4 do\n",
                                "\no4 while[0]\n",
                                "#<a>",
                                "#<a>=1 ",
                                "**",
                                "EXISTS[#<b>]",
                                "@1 ",
                                "^2",
                                "$1 ",
                                "(DEBUG,#1 %d\")",
                                "(PRINT,%)",
                                "G777 ",
                                "G64P1",
                                "\no5 repeat[2]\n",
                                "\no5 endrepeat\n",
                                "\no3 return [1]\n",
                                "#<end>=2",
                                "X 1 2",
                                "G38.2 "};

template <std::size_t own>
std::string soup(std::mt19937& random, const char* const (&fragments)[own]) {
    std::string text;
    for (std::size_t count = random() % 50; count > 0; --count) {
        const std::size_t choice = random() % (std::size(kShared) + 2 * own);
        text +=
            choice < std::size(kShared) ? kShared[choice] : fragments[(choice - std::size(kShared)) % own];
    }
    return text;
}

/// A few blocks that are right by themselves, so that some programs are accepted.
template <std::size_t own>
std::string short_soup(std::mt19937& random, const char* const (&fragments)[own]) {
    std::string text;
    for (std::size_t count = 1 + random() % 4; count > 0; --count) {
        const std::size_t choice = random() % (std::size(kShared) + 2 * own);
        text +=
            choice < std::size(kShared) ? kShared[choice] : fragments[(choice - std::size(kShared)) % own];
    }
    return text;
}

/// True if it was accepted.
bool expect_sound(const std::string& gcode, const TranslateOptions& options) {
    const Translated first = translated(gcode, options);
    const Translated second = translated(gcode, options);
    EXPECT_EQ(first.messages, second.messages) << gcode;
    EXPECT_EQ(first.lua, second.lua) << gcode;
    EXPECT_EQ(first.ok, first.messages.find("error: ") == std::string::npos) << gcode << first.messages;
    EXPECT_EQ(first.messages.find("gave up"), std::string::npos) << gcode;
    EXPECT_EQ(first.messages.find("cannot be understood"), std::string::npos) << gcode;
    if (first.ok) {
        EXPECT_EQ(compile_error(first.lua), std::nullopt) << gcode << "\n" << first.lua;
    }
    return first.ok;
}

template <std::size_t own>
void expect_all_sound(const grammar::Dialect& dialect, const char* const (&fragments)[own]) {
    std::mt19937 random(30);
    int accepted = 0;
    for (int i = 0; i < 6000; ++i) {
        const std::string gcode = i % 3 == 0 ? soup(random, fragments) : short_soup(random, fragments);
        TranslateOptions options;
        options.dialect = &dialect;
        options.unknown = i % 2 == 0 ? UnknownCodePolicy::warn : UnknownCodePolicy::error;
        options.annotate = i % 4 < 2;
        accepted += expect_sound(gcode, options) ? 1 : 0;
        ASSERT_FALSE(testing::Test::HasFailure()) << "program " << i;
    }
    EXPECT_GT(accepted, 500) << "the soup is too thick";
}

TEST(TokenSoup, Ab9TranslationIsRepeatableAndCompiles) {
    expect_all_sound(grammar::dialect_ab9(), kAb9);
}

TEST(TokenSoup, NgcTranslationIsRepeatableAndCompiles) {
    expect_all_sound(grammar::dialect_rs274ngc(), kNgc);
}

std::ptrdiff_t lines(std::string_view text) {
    const bool open_end = !text.empty() && text.back() != '\n';
    return std::count(text.begin(), text.end(), '\n') + (open_end ? 1 : 0);
}

TEST(RandomNgcPrograms, AreAcceptedAndKeepLines) {
    std::mt19937 random(31);
    for (int i = 0; i < 300; ++i) {
        const std::string gcode = random_ngc_program(random, 60);
        const Translated result = translated_ngc(gcode);
        ASSERT_TRUE(result.ok) << result.messages << gcode;
        const std::ptrdiff_t behind_the_last_line = lines(result.lua) - lines(gcode) - 1;
        ASSERT_TRUE(behind_the_last_line == 0 || result.lua.ends_with("\nend)\n")) << gcode << "\n"
                                                                                   << result.lua;
        ASSERT_LE(behind_the_last_line, 1) << gcode << "\n" << result.lua;
        ASSERT_EQ(compile_error(result.lua), std::nullopt) << gcode << "\n" << result.lua;
        ASSERT_TRUE(script_origin(result.lua).unedited);
    }
}

/// A random program with one line lost or doubled: refused or accepted, never Lua that does not compile.
TEST(RandomNgcPrograms, LostOrDoubledLineIsRejectedOrCompiles) {
    std::mt19937 random(32);
    TranslateOptions options;
    options.dialect = &grammar::dialect_rs274ngc();
    for (int i = 0; i < 1000; ++i) {
        std::string gcode = random_ngc_program(random, 25);
        const std::size_t begin = gcode.find('\n', random() % (gcode.size() + 1));
        if (begin == std::string::npos) continue;
        const std::size_t end = gcode.find('\n', begin + 1);
        if (end == std::string::npos) continue;
        const std::string line = gcode.substr(begin, end - begin);
        if (i % 2 == 0) {
            gcode.erase(begin, end - begin);
        } else {
            gcode.insert(begin, line);
        }
        expect_sound(gcode, options);
        ASSERT_FALSE(testing::Test::HasFailure()) << "program " << i;
    }
}

}  // namespace
}  // namespace gsim::codegen::token_soup_test
