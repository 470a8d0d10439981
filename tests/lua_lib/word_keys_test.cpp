// Keys of words' tables: those that programs can write, and an error for any other.

#include <fmt/format.h>

#include "grammar/dialect.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::word_keys_test {
namespace {

/// The keys that the translator can write for a code, in the order of the dialect's table.
std::string keys_of(const grammar::Code& code) {
    std::string keys;
    const auto add = [&](const std::string& key) { keys += (keys.empty() ? "" : ", ") + key; };
    if (code.axes != grammar::AxisUse::none) add("a, b, c, u, v, w, x, y, z, radius, angle");
    for (const char letter : code.words) {
        if (letter == '$') add("spindle");
        if (letter >= 'A' && letter <= 'Z') add(std::string(1, static_cast<char>(letter | 0x20)));
    }
    return keys;
}

/// Plain motions and macro calls check their keys themselves; user codes take any.
bool checks_words_itself(const grammar::Code& code) {
    const std::string name = grammar::lua_name(code);
    for (const char* own : {"G0", "G1", "G2", "G3", "G65", "G66", "G66_1"}) {
        if (name == own) return true;
    }
    return name[0] == 'M' && name[1] == '[';
}

class WordKeys : public testing::TestWithParam<const char*> {};

TEST_P(WordKeys, MatchDialect) {
    Conditions setup;
    setup.options.dialect = GetParam();
    std::size_t checked_bodies = 0;
    for (const grammar::Code& code : grammar::find_dialect(GetParam())->codes()) {
        const std::string keys = keys_of(code);
        if (keys.empty() || code.support != grammar::Support::full || checks_words_itself(code)) continue;
        const Outcome r = run_lua(fmt::format("{}{{[\"%\"]=1}}", grammar::lua_name(code)), setup);
        EXPECT_EQ(r.message(),
                  fmt::format("'%' is not a word of {}; it accepts {}", grammar::code_name(code), keys));
        ++checked_bodies;
    }
    EXPECT_GT(checked_bodies, 30U);
}

INSTANTIATE_TEST_SUITE_P(Dialects, WordKeys, testing::Values("ab9", "rs274ngc"));

TEST_P(WordKeys, RejectionsDuringCompensationMatchDialect) {
    using grammar::Compensation;
    Conditions setup = with_tools();
    setup.options.dialect = GetParam();
    std::size_t checked_bodies = 0;
    for (const grammar::Code& code : grammar::find_dialect(GetParam())->codes()) {
        if (code.group == grammar::Group::user || code.support != grammar::Support::full) continue;
        const std::string call = grammar::lua_name(code) + "()";
        const std::string message =
            run_lua("F(600) D(1) G41{d=1} G1{x=20} G1{x=40}\n" + call, setup).message();
        const bool is_rejected = code.compensation == Compensation::rejected ||
                                 code.compensation == Compensation::refused_next_to_path;
        EXPECT_EQ(message == grammar::code_name(code) +
                                 " is not possible while cutter compensation is on; program G40 first",
                  is_rejected)
            << message;
        if (is_rejected) ++checked_bodies;
    }
    EXPECT_GT(checked_bodies, 15U);
}

std::string said(const std::string& script) {
    const Outcome r = run_lua(script);
    EXPECT_EQ(r.line(), 1U) << script;
    return r.message();
}

TEST(WordSuggestions, NameCorrectWord) {
    EXPECT_EQ(said("G1{X=100}"), "'X' is not a word of this motion; write x");
    EXPECT_EQ(said("G2{x=1, I=2}"), "'I' is not a word of this motion; write i");
    EXPECT_EQ(said("G28{X=1}"), "'X' is not a word of G28; write x");
    EXPECT_EQ(said("M98{P=1}"), "'P' is not a word of M98; write p");
    EXPECT_EQ(said("F(50) G1{x=10, f=100}"),
              "'f' is not a word of this motion; the feed is a separate word, F(100)");
    EXPECT_EQ(said("G0{x=10, S=2500}"),
              "'S' is not a word of this motion; the spindle speed is a separate word, S(2500)");
    EXPECT_EQ(said("G0{q=1}"), "'q' is not a word of this motion; it accepts x, y, z, b, c");
    EXPECT_EQ(said("G28{radios=1}"), "'radios' is not a word of G28; did you mean radius?");
}

TEST(EnumArguments, ErrorListsValuesAndSuggestsNearest) {
    EXPECT_EQ(said("rrs.SelectMotionType(\"Linear\")"),
              "bad argument #1 to 'SelectMotionType' ('Linear' must be one of \"joint\", \"linear\", "
              "\"circular\"; did you mean \"linear\"?)");
    EXPECT_EQ(said("rrs.SelectTargetType(\"xy\")"),
              "bad argument #1 to 'SelectTargetType' ('xy' must be one of \"cartesian\", \"joint\")");
}

TEST(ArgumentErrors, NameFunctionForAnyCall) {
    EXPECT_EQ(said("local done, text = pcall(rrs.SetCartesianPositionSpeed, \"a\") error(text, 0)"),
              "bad argument #1 to 'rrs.SetCartesianPositionSpeed' (number expected, got string)");
    EXPECT_EQ(said("table.concat(5)"), "bad argument #1 to 'table.concat' (table expected, got number)");
}

}  // namespace
}  // namespace gsim::script::word_keys_test
