#include "grammar/dialect.h"

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::grammar::dialect_test {
namespace {

TEST(Dialect, CodesAreUniqueAndFound) {
    for (const Dialect* dialect : dialects()) {
        std::set<std::string> names;
        for (const Code& code : dialect->codes()) {
            EXPECT_TRUE(names.insert(code_name(code)).second) << code_name(code) << " stands twice";
            EXPECT_EQ(dialect->find(code.letter, code.code_x10), &code) << code_name(code);
            EXPECT_FALSE(code.meaning.empty()) << code_name(code);
        }
    }
}

/// A letter that a code takes must have a meaning in the dialect, and must not be an axis already.
TEST(Dialect, CodesUseOnlyLettersOfDialect) {
    for (const Dialect* dialect : dialects()) {
        std::string letters;
        for (const Letter& letter : dialect->rules().letters) letters += letter.address;
        for (const Code& code : dialect->codes()) {
            std::set<char> seen;
            for (const char letter : code.words) {
                EXPECT_TRUE(seen.insert(letter).second) << code_name(code) << " has " << letter << " twice";
                const bool known = letters.find(letter) != std::string::npos;
                EXPECT_TRUE(known || letter == '1' || letter == ',' || letter == '*' || letter == 'E')
                    << dialect->name() << " " << code_name(code) << " " << letter;
            }
        }
    }
}

TEST(Dialect, InitialCodesExistInDifferentGroups) {
    for (const Dialect* dialect : dialects()) {
        std::istringstream initial{std::string(dialect->rules().initial)};
        std::set<Group> groups;
        for (std::string name; initial >> name;) {
            const auto code_x10 = static_cast<std::int32_t>(std::stod(name.substr(1)) * 10 + 0.5);
            const Code* code = dialect->find(name[0], code_x10);
            ASSERT_NE(code, nullptr) << dialect->name() << " " << name;
            EXPECT_EQ(code_name(*code), name);
            EXPECT_TRUE(groups.insert(code->group).second) << name;
            EXPECT_EQ(code->support, Support::full) << name;
        }
    }
}

TEST(Dialect, Rs274NgcMarksUnsupportedCodesAsPlanned) {
    for (const int code_x10 : {171, 181, 191, 700, 710, 711, 720}) {
        const Code* code = dialect_rs274ngc().find('G', code_x10);
        ASSERT_NE(code, nullptr) << code_x10;
        EXPECT_EQ(code->support, Support::planned) << code_x10;
    }
    for (const int code_x10 :
         {50, 51, 52, 53, 281, 301, 331, 382, 385, 411, 431, 432, 593, 611, 901, 911, 922})
        EXPECT_NE(dialect_rs274ngc().find('G', code_x10), nullptr) << code_x10;
    for (const int code_x10 : {480, 500, 530, 600, 610, 620, 660, 680, 700, 730, 1000, 1990}) {
        const Code* code = dialect_rs274ngc().find('M', code_x10);
        ASSERT_NE(code, nullptr) << code_x10;
        EXPECT_EQ(code->support, Support::full) << code_x10;
    }
    EXPECT_EQ(dialect_rs274ngc().find('M', 2000), nullptr);
    EXPECT_EQ(dialect_rs274ngc().find('G', 650), nullptr);
}

/// LinuxCNC's documented order: feed mode, F, S, T, M6, spindle, coolant, overrides, dwell, plane, units,
/// compensation, lengths, coordinate system, path mode, distance mode, cycle level, data, motion, stop.
TEST(Dialect, Rs274NgcHasExecutionOrderOfLinuxCnc) {
    const Dialect& ngc = dialect_rs274ngc();
    const std::vector<Phase> order = {
        Phase::feed_mode, Phase::feed,         Phase::spindle_speed, Phase::tool,       Phase::tool_change,
        Phase::switch_on, Phase::switch_off,   Phase::pause,         Phase::dwell,      Phase::plane,
        Phase::units,     Phase::compensation, Phase::tool_length,   Phase::work_frame, Phase::path_mode,
        Phase::distance,  Phase::cycle,        Phase::data,          Phase::motion,     Phase::flow};
    for (std::size_t i = 1; i < order.size(); ++i)
        EXPECT_LT(ngc.rank(order[i - 1]), ngc.rank(order[i])) << name(order[i - 1]) << ", " << name(order[i]);
    for (const Dialect* dialect : {&dialect_ab9(), &ngc}) {
        std::set<int> ranks;
        for (std::size_t phase = 0; phase < kPhaseCount; ++phase)
            EXPECT_TRUE(ranks.insert(dialect->rank(static_cast<Phase>(phase))).second) << phase;
    }
}

TEST(Dialect, UnknownCodesAreNotFound) {
    for (const std::int32_t code : {-1, 15, 51, 1000, 6000, 99999, 2147483647})
        EXPECT_EQ(dialect_ab9().find('G', code), nullptr) << code;
    EXPECT_EQ(dialect_ab9().find('M', 770), nullptr);
    EXPECT_EQ(dialect_ab9().find('G', 5040), nullptr) << "the settable frames start at G505";
    EXPECT_NE(dialect_ab9().find('G', 5050), nullptr);
    EXPECT_NE(dialect_ab9().find('G', 5990), nullptr);
}

TEST(Dialect, Ab9HasCodesOfMachine) {
    for (const int g :
         {0, 1, 2, 3, 4, 9, 15, 16, 17, 18, 19, 20, 21, 23, 40, 52, 53, 54, 55, 61, 64, 90, 91, 92, 93, 94}) {
        const Code* code = dialect_ab9().find('G', g * 10);
        ASSERT_NE(code, nullptr) << "G" << g;
        EXPECT_EQ(code->support, Support::full) << "G" << g;
    }
    for (const int g : {14, 22, 41, 42}) EXPECT_NE(dialect_ab9().find('G', g * 10), nullptr) << "G" << g;
    EXPECT_NE(dialect_ab9().find('G', 921), nullptr);
    EXPECT_NE(dialect_ab9().find('G', 141), nullptr);
    for (const int m : {0, 1, 2, 8, 9, 10, 11, 30, 98, 99}) {
        const Code* code = dialect_ab9().find('M', m * 10);
        ASSERT_NE(code, nullptr) << "M" << m;
        EXPECT_EQ(code->support, Support::full) << "M" << m;
    }
}

TEST(Dialect, Ab9CodesHaveExpectedModalGroups) {
    const std::vector<std::vector<int>> groups = {
        {0, 1, 2, 3}, {17, 18, 19}, {20, 21},
        {90, 91},     {93, 94, 95}, {15, 16},
        {61, 64},     {40, 41, 42}, {54, 55, 56, 57, 58, 59, 505, 599}};
    const auto group = [](int g) { return dialect_ab9().find('G', g * 10)->group; };
    std::set<Group> seen;
    for (const std::vector<int>& codes : groups) {
        for (const int g : codes) EXPECT_EQ(group(g), group(codes[0])) << "G" << g;
        EXPECT_TRUE(seen.insert(group(codes[0])).second) << "G" << codes[0];
        EXPECT_NE(group(codes[0]), Group::none);
    }
    EXPECT_NE(group(80), group(0)) << "two groups in the 9/Series";
    for (const int g : {4, 9, 28, 52, 53, 92}) EXPECT_EQ(group(g), Group::none) << "G" << g;
}

TEST(Dialect, GroupsAndPhasesHaveUniqueNames) {
    std::set<std::string_view> names;
    for (std::size_t g = 0; g < kGroupCount; ++g) {
        EXPECT_FALSE(name(static_cast<Group>(g)).empty()) << g;
        EXPECT_TRUE(names.insert(name(static_cast<Group>(g))).second) << g;
    }
    EXPECT_EQ(name(static_cast<Group>(kGroupCount)), "") << "the count is right";
    names.clear();
    for (std::size_t p = 0; p < kPhaseCount; ++p) {
        EXPECT_FALSE(name(static_cast<Phase>(p)).empty()) << p;
        EXPECT_TRUE(names.insert(name(static_cast<Phase>(p))).second) << p;
    }
    EXPECT_EQ(name(static_cast<Phase>(kPhaseCount)), "");
}

TEST(Dialect, IsFoundByName) {
    EXPECT_EQ(find_dialect("ab9"), &dialect_ab9());
    EXPECT_EQ(find_dialect("rs274ngc"), &dialect_rs274ngc());
    EXPECT_EQ(find_dialect("klipper"), &dialect_klipper());
    EXPECT_EQ(find_dialect("fanuc"), nullptr);
    EXPECT_EQ(find_dialect(""), nullptr);
}

TEST(Dialect, FormatsCodeNames) {
    EXPECT_EQ(code_name(*dialect_ab9().find('G', 921)), "G92.1");
    EXPECT_EQ(lua_name(*dialect_ab9().find('G', 921)), "G92_1");
    EXPECT_EQ(lua_name(*dialect_ab9().find('M', 80)), "M8");
    EXPECT_EQ(lua_name(*dialect_ab9().find('G', 5050)), "G505");
    EXPECT_EQ(lua_name(*dialect_ab9().find('M', 1010)), "M[101]");
    EXPECT_EQ(code_name(*dialect_ab9().find('M', 9990)), "M999");
    EXPECT_EQ(dialect_ab9().find('M', 10000), nullptr);
    EXPECT_EQ(code_name(*dialect_rs274ngc().find('G', 593)), "G59.3");
}

}  // namespace
}  // namespace gsim::grammar::dialect_test
