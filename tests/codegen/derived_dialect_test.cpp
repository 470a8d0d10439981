// A dialect that is described by its differences from another one.
#include <array>
#include <stdexcept>

#include <gtest/gtest.h>

#include "codegen/translate.h"
#include "grammar/rows.h"

namespace gsim::codegen::derived_dialect_test {
namespace {

using grammar::Code;
using grammar::Dialect;
using grammar::DialectRules;
using grammar::remove_rows;
using grammar::set_rows;

constexpr std::array kCodes = {
    Code{'G', 370, grammar::Group::none, grammar::Phase::data, grammar::AxisUse::data, "R",
         grammar::Support::full, "tool length measurement"},
    Code{'G', 40, grammar::Group::none, grammar::Phase::dwell, grammar::AxisUse::none, "PXUS",
         grammar::Support::full, "dwell"},
};

/// The 9/Series with `**`, G37 and S of G4, and without part rotation and SQR.
void change(DialectRules& rules) {
    rules.name = "x";
    rules.title = "X";
    rules.lua_module = "gsim.x";
    rules.text.has_power_operator = true;
    set_rows(rules.codes, kCodes);
    remove_rows(rules.codes, {{'G', 680}, {'G', 690}});
    remove_rows(rules.expression_names, {"SQR"});
}

TextTranslation translated(const Dialect& dialect, std::string_view gcode) {
    TranslateOptions options;
    options.dialect = &dialect;
    return translate_text(gcode, options);
}

/// Returns the Lua of the only line.
std::string lua_of(const Dialect& dialect, std::string_view line) {
    const TextTranslation translation = translated(dialect, line);
    EXPECT_TRUE(translation.ok) << translation.diagnostics;
    const std::size_t begin = translation.lua.find('\n') + 1;
    return translation.lua.substr(begin, translation.lua.find('\n', begin) - begin);
}

TEST(DerivedDialect, InheritsUnsetProperties) {
    const Dialect x(grammar::dialect_ab9(), change);
    EXPECT_EQ(translated(x, "G1X5\n").lua.find("local _ENV = require \"gsim.x\""), 0U);
    for (const std::string_view line : {"G1 X10,R2 F100", "IF[#1 EQ 5]THEN #2=1", "M98 P2 L3", "X5 G4",
                                        "#3000=1(BROKEN)", "DPRNT[X#100[53]]", "G1 X[SQRT[#1]] (a (b)"})
        EXPECT_EQ(lua_of(x, line), lua_of(grammar::dialect_ab9(), line)) << line;
}

TEST(DerivedDialect, HasChangedProperty) {
    const Dialect x(grammar::dialect_ab9(), change);
    EXPECT_EQ(lua_of(x, "#1=#2**3"), "v[1] = POW(v[2], 3.0)");
    EXPECT_NE(translated(grammar::dialect_ab9(), "#1=#2**3\n").diagnostics.find("'**' is not an operator"),
              std::string::npos);
}

TEST(DerivedDialect, HasAddedAndChangedWords) {
    const Dialect x(grammar::dialect_ab9(), change);
    EXPECT_EQ(lua_of(x, "G37 Z0 R5"), "G37{z=0, r=5}");
    EXPECT_EQ(lua_of(x, "G4 S2"), "G4{s=2}");
    EXPECT_EQ(grammar::dialect_ab9().find('G', 370), nullptr);
    EXPECT_EQ(x.codes().size(), grammar::dialect_ab9().codes().size() - 1) << "one added, two removed";
}

TEST(DerivedDialect, RejectsRemovedWords) {
    const Dialect x(grammar::dialect_ab9(), change);
    EXPECT_NE(translated(x, "G68 X0 Y0 R30\n").diagnostics.find("G68 is not a code of X"), std::string::npos);
    EXPECT_NE(translated(x, "X[SQR[4]]\n").diagnostics.find("'SQR' is not a function"), std::string::npos);
    EXPECT_TRUE(translated(grammar::dialect_ab9(), "G68 X0 Y0 R30\nX[SQR[4]]\n").ok);
}

TEST(DerivedDialect, ThrowsIfRemovedWordIsMissing) {
    const auto remove_missing = [](DialectRules& rules) { remove_rows(rules.codes, {{'G', 370}}); };
    EXPECT_THROW(Dialect(grammar::dialect_ab9(), remove_missing), std::invalid_argument);
}

}  // namespace
}  // namespace gsim::codegen::derived_dialect_test
