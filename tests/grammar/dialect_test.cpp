#include "grammar/dialect.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::grammar {
namespace {

TEST(Dialect, NoCodeStandsTwiceAndEachIsFound) {
    std::set<std::string> names;
    for (const Code& code : dialect_ab9().codes()) {
        EXPECT_TRUE(names.insert(code_name(code)).second) << code_name(code) << " stands twice";
        EXPECT_EQ(dialect_ab9().find(code.letter, code.code_x10), &code) << code_name(code);
        EXPECT_FALSE(code.meaning.empty()) << code_name(code);
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

TEST(Dialect, HasTheCodesOfTheMachine) {
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

TEST(Dialect, ModalGroups) {
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

TEST(Dialect, EveryGroupHasAName) {
    std::set<std::string_view> names;
    for (int g = 0; g <= static_cast<int>(Group::override_switch); ++g) {
        EXPECT_FALSE(name(static_cast<Group>(g)).empty()) << g;
        EXPECT_TRUE(names.insert(name(static_cast<Group>(g))).second) << g;
    }
}

TEST(Dialect, Names) {
    EXPECT_EQ(code_name(*dialect_ab9().find('G', 921)), "G92.1");
    EXPECT_EQ(lua_name(*dialect_ab9().find('G', 921)), "G92_1");
    EXPECT_EQ(lua_name(*dialect_ab9().find('M', 80)), "M8");
    EXPECT_EQ(lua_name(*dialect_ab9().find('G', 5050)), "G505");
}

}  // namespace
}  // namespace gsim::grammar
