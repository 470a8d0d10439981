// docs/language.md is made from the tables that the translator runs by.
#include "codegen/language_page.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "grammar/dialect.h"
#include "lexer/names.h"
#include "tests/build_files/build_files.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::language_page_test {
namespace {

TEST(LanguagePage, MatchesFileInDocs) {
    std::ifstream in(tests::source_path("docs/language.md"), std::ios::binary);
    ASSERT_TRUE(in) << "docs/language.md cannot be opened";
    const std::string page(std::istreambuf_iterator<char>(in), {});
    EXPECT_TRUE(page == language_page())
        << "docs/language.md is not what the tables say; `make docs` writes it anew";
}

/// The part of the page about one dialect.
std::string page_part(const grammar::Dialect& dialect) {
    const std::string page = language_page();
    const std::size_t begin = page.find(fmt::format("\n## {} (", dialect.title()));
    EXPECT_NE(begin, std::string::npos);
    return page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

TEST(LanguagePage, HasEveryCodeWithItsMeaning) {
    for (const grammar::Dialect* dialect : grammar::dialects()) {
        const std::string part = page_part(*dialect);
        for (const grammar::Code& code : dialect->codes()) {
            const bool in_a_range = code.group == grammar::Group::user || code.code_x10 >= 5050;
            const std::string row = fmt::format("\n| {} | {} |", grammar::code_name(code), code.meaning);
            EXPECT_TRUE(in_a_range || part.find(row) != std::string::npos) << dialect->name() << row;
        }
        for (const grammar::Letter& letter : dialect->rules().letters) {
            EXPECT_NE(part.find(fmt::format("\n| {} | {} |\n", letter.address, letter.meaning)),
                      std::string::npos)
                << letter.address;
        }
    }
    EXPECT_NE(page_part(grammar::dialect_ab9()).find("\n| G505 to G599 | settable frame |"),
              std::string::npos);
    EXPECT_NE(page_part(grammar::dialect_ab9()).find("\n| M100 to M999 | user code |"), std::string::npos);
    EXPECT_NE(page_part(grammar::dialect_rs274ngc()).find("\n| M100 to M199 | user code |"),
              std::string::npos);
}

TEST(LanguagePage, HasEveryNamedCommand) {
    const std::string klipper = page_part(grammar::dialect_klipper());
    for (const grammar::ExtendedCommand& command : grammar::dialect_klipper().rules().extended) {
        EXPECT_NE(klipper.find(fmt::format("\n| {} | ", command.name)), std::string::npos) << command.name;
        EXPECT_NE(klipper.find(command.meaning), std::string::npos) << command.name;
    }
}

bool has_name(const grammar::Dialect& dialect, const lexer::ExpressionName& name) {
    const auto& names = dialect.rules().expression_names;
    return std::any_of(names.begin(), names.end(), [&](const lexer::ExpressionName& one) {
        return one.name == name.name && one.meaning == name.meaning;
    });
}

TEST(LanguagePage, HasEveryFunctionAndOWord) {
    const std::string ngc = page_part(grammar::dialect_rs274ngc());
    const std::array dialects{&grammar::dialect_ab9(), &grammar::dialect_rs274ngc()};
    for (const grammar::Dialect* dialect : dialects) {
        for (const lexer::ExpressionName& name : dialect->rules().expression_names) {
            const std::string row = fmt::format("\n| {} | {} |\n", name.name, name.meaning);
            for (const grammar::Dialect* other : dialects)
                EXPECT_EQ(page_part(*other).find(row) != std::string::npos, has_name(*other, name)) << row;
        }
    }
    for (const lexer::FlowName& flow : lexer::kFlowNames)
        EXPECT_NE(ngc.find(flow.meaning), std::string::npos) << flow.name;
}

/// The page's statements in the form `G-code` | `Lua` are those of the translator.
TEST(LanguagePage, BlockExamplesMatchTranslator) {
    EXPECT_EQ(lua_of("#1=#2+4"), "v[1] = v[2] + 4.0");
    EXPECT_EQ(lua_of("X-[#1+2]"), "move{x=(-(v[1] + 2.0))}");
    EXPECT_EQ(lua_of("DPRNT[X#100[53]]"), "DPRNT(\"X%.3f\", v[100])");
    EXPECT_EQ(lua_of("#3000=1(TOOL BROKEN)"), "message(\"TOOL BROKEN\") v[3000] = 1.0");
    EXPECT_EQ(lua_of("G1X10,R2"), "corner(2) G1{x=10}");
    EXPECT_EQ(ngc_lua_of("#1=2 #2=#1"), "v[1], v[2] = 2.0, v[1]");
    EXPECT_EQ(ngc_lua_of("#1=exists[#<width>]"), "v[1] = exists(\"width\")");
    EXPECT_EQ(ngc_lua_of("#3=[#1 EQ 2] #4=[#1 ** 2]"),
              "v[3], v[4] = number(equal(v[1], 2.0)), POW(v[1], 2.0)");
    EXPECT_EQ(ngc_lua_of("o<drill> call [1] [2]"), "call(\"drill\", 1.0, 2.0)");
    EXPECT_EQ(ngc_lua_of("(DEBUG,x=#1)"), "DEBUG(\"x=%f\", v[1])");
    EXPECT_EQ(ngc_lua_of("G1 @5 ^30"), "G1{radius=5, angle=30}");
}

}  // namespace
}  // namespace gsim::codegen::language_page_test
