// Paramacros: arguments, levels of local variables, modal calls.

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_macros_test {
namespace {

// A main program and macros by number; line 2 is the first one of the main program.
Outcome run_macros(const std::string& main, const std::vector<std::pair<int, std::string>>& macros) {
    std::string lua = "program(1, function()\n" + main + "\nend)\n";
    for (const auto& [number, body] : macros)
        lua += fmt::format("program({}, function()\n{}\ndo return M99() end\nend)\n", number, body);
    return run_lua("local _ENV = require \"gsim\" " + lua);
}

TEST(Macros, EachArgumentSetsItsVariable) {
    const std::pair<char, int> scheme[] = {{'a', 1},  {'b', 2},  {'c', 3},  {'d', 7},  {'e', 8},  {'f', 9},
                                           {'h', 11}, {'i', 4},  {'j', 5},  {'k', 6},  {'m', 13}, {'q', 17},
                                           {'r', 18}, {'s', 19}, {'t', 20}, {'u', 21}, {'v', 22}, {'w', 23},
                                           {'x', 24}, {'y', 25}, {'z', 26}};
    for (const auto& [letter, number] : scheme) {
        const Outcome r = run_macros(fmt::format("G65{{p=100, {}=7}}", letter),
                                     {{100, fmt::format("G0{{x=v[{}], y=v[{}]}}", number, number + 100)}});
        expect_end(r, 7, 0, 0);
    }
}

TEST(Macros, RepeatedIJKFillSetsOfThree) {
    expect_end(run_macros("G65{p=100, a=1, {\"i\",1}, {\"j\",2}, {\"i\",4}}",
                          {{100, "G0{x=v[4], y=v[5], z=v[7], b=v[1], c=v[8]}"}}),
               1, 2, 4, 1, 0);
    expect_end(
        run_macros("G65{p=100, {\"k\",1}, {\"k\",2}, {\"j\",3}}", {{100, "G0{x=v[6], y=v[9], z=v[11]}"}}), 1,
        2, 3);
    expect_alarm(run_macros("G65{p=100, d=1, {\"i\",1}, {\"i\",2}}", {{100, ""}}), 2, {"#7", "I"});
}

TEST(Macros, LocalVariablesBelongToMacroLevel) {
    expect_end(run_macros("v[1]=7.0 v[2]=8.0 G65{p=100, a=1} G0{y=v[1], z=v[2]}",
                          {{100, "G0{x=v[1], z=v[2]} v[1]=99.0 v[2]=98.0"}}),
               1, 7, 8);
    // Common variables do not.
    expect_end(run_macros("v[100]=1.0 G65{p=100} G0{x=v[100]}", {{100, "v[100]=5.0"}}), 5, 0, 0);
    // M98 opens no level.
    expect_end(run_macros("v[1]=1.0 M98{p=100} G0{x=v[1]}", {{100, "v[1]=5.0"}}), 5, 0, 0);
}

TEST(Macros, G65RepeatsByL) {
    expect_end(run_macros("G91() G65{p=100, l=3, a=5}", {{100, "G0{x=v[1]}"}}), 15, 0, 0);
    expect_end(run_macros("G91() G65{p=100, l=0, a=5}", {{100, "G0{x=v[1]}"}}), 0, 0, 0);
}

TEST(Macros, NestToFourLevels) {
    std::vector<std::pair<int, std::string>> chain;
    for (int n = 1; n < 4; ++n) chain.emplace_back(100 + n, fmt::format("G65{{p={}, a=v[1]+1}}", 101 + n));
    chain.emplace_back(104, "G0{x=v[1]}");
    expect_end(run_macros("G65{p=101, a=1}", chain), 4, 0, 0);
    chain.back().second = "G65{p=105}";
    chain.emplace_back(105, "");
    const Outcome r = run_macros("G65{p=101, a=1}", chain);
    EXPECT_NE(r.message().find("O105"), std::string::npos) << r.message();
    EXPECT_NE(r.message().find("4 macro levels"), std::string::npos) << r.message();
}

TEST(Macros, RejectsInvalidArguments) {
    expect_alarm(run_macros("G65{p=100, g=1}", {{100, ""}}), 2,
                 {"[word-out-of-place]", "G65", "G is not an argument"});
    expect_alarm(run_macros("G65{a=1}", {}), 2, {"[word-missing]", "G65", "P,"});
    expect_alarm(run_macros("G65{p=100, l=1.5}", {{100, ""}}), 2, {"L of G65", "1.5"});
    expect_alarm(run_macros("\nG65{p=77}", {}), 3, {"O77"});
}

TEST(ModalMacros, RunAfterEachMove) {
    const Outcome r = run_macros("G66{p=100, z=5}\nG0{x=10}\nM8()\nmove{x=20}\nG67()\nmove{x=30}",
                                 {{100, "G0{z=v[26]} G0{z=0}"}});
    expect_end(r, 30, 0, 0);
    ASSERT_EQ(r.moves.size(), 7U);
    EXPECT_NEAR(r.to(1, 'Z'), 5, 1e-9);
    EXPECT_NEAR(r.to(4, 'Z'), 5, 1e-9);
    EXPECT_NEAR(r.to(4, 'X'), 20, 1e-9);
}

TEST(ModalMacros, KeepLocalVariablesBetweenCalls) {
    expect_end(run_macros("G66{p=100, z=5} G0{x=10} G0{x=20} G0{x=30}", {{100, "v[26]=v[26]+1 G0{z=v[26]}"}}),
               30, 0, 8);
}

TEST(ModalMacros, MovesOfLastMacroCallPreviousMacro) {
    // Macro 100 counts; macro 200 makes two moves.
    const std::vector<std::pair<int, std::string>> macros{{100, "v[110]=v[110]+1"}, {200, "G0{y=1} G0{y=0}"}};
    expect_end(run_macros("G66{p=100} G66{p=200} G0{x=10} G67() G67() G0{z=v[110]}", macros), 10, 0, 2);
    expect_end(run_macros("G66{p=100} G66{p=200} G67() G0{x=10} G67() G0{z=v[110]}", macros), 10, 0, 1);
}

TEST(ModalMacros, G661PassesWordsOfEachBlock) {
    const std::string collect = "v[100]=v[100]+1 v[101]=v[24] v[102]=v[9] v[103]=v[10] v[104]=v[26]";
    const std::string show = "\nG67() G0{x=v[101], y=v[102], z=v[103], b=v[104], c=v[100]}";
    expect_end(run_macros("G66_1{p=100}\nF(30.0) G1{x=7, z=3}" + show, {{100, collect}}), 7, 30, 1, 3, 1);
    expect_end(run_macros("G66_1{p=100}\nF(30.0)\nmove{x=7}" + show, {{100, collect}}), 7, 0, 0, 0, 2);
    EXPECT_EQ(run_macros("G66_1{p=100}\nG0{x=7}\nG67()", {{100, collect}}).moves.size(), 0U);
    expect_alarm(run_macros("G66_1{p=100, a=1}", {{100, ""}}), 2,
                 {"[word-out-of-place]", "G66.1", "no arguments"});
}

}  // namespace
}  // namespace gsim::script::ab9_macros_test
