#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lexer/scan.h"

namespace gsim::lexer::alias_test {
namespace {

using testing::ElementsAre;

Aliases prints() {
    Aliases aliases;
    EXPECT_FALSE(aliases.add("Print", "M10"));
    EXPECT_FALSE(aliases.add("Printed", "M11"));
    EXPECT_FALSE(aliases.add("ImPrint", "G01"));
    return aliases;
}

TEST(Aliases, NameContainedInAnotherIsDistinct) {
    const Scan result = scan("Print\nPrinted\nImPrint X5\nPRINTED print imprint\n", prints());
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.words, ElementsAre("M=10", "M=11", "G=01", "X=5", "M=11", "M=10", "G=01"));
}

TEST(Aliases, AliasWithSuffixIsUnknown) {
    EXPECT_EQ(
        scan("Prints X5\n", prints()).messages,
        "1:1: error: 'Prints' is neither a keyword nor an alias of the machine data; did you mean PRINT?\n");
    EXPECT_EQ(
        scan("Print5\n", prints()).messages,
        "1:1: error: 'Print5' is neither a keyword nor an alias of the machine data; did you mean PRINT?\n");
    EXPECT_EQ(scan("Something\n", prints()).messages,
              "1:1: error: 'Something' is neither a keyword nor an alias of the machine data\n");
    EXPECT_EQ(
        scan("WHILST[1]DO1\n").messages,
        "1:1: error: 'WHILST' is neither a keyword nor an alias of the machine data; did you mean WHILE?\n");
}

TEST(Aliases, HaveTokenKindsOfTheirWords) {
    Aliases aliases;
    ASSERT_FALSE(aliases.add("Wait", "G04"));
    ASSERT_FALSE(aliases.add("Sub", "m98"));
    EXPECT_THAT(scan("X5 Wait\nSub P2\n", aliases).tokens,
                ElementsAre(kAxisOrTime, kDwell, kEob, kCall, kP, kEob));
}

TEST(Aliases, RejectInvalidNamesAndWords) {
    Aliases aliases;
    const std::string bad_name =
        " is not a valid name of an alias: it must begin with at least two letters, then letters, digits and "
        "'_'";
    for (const std::string name : {"", "X", "X1", "1ab", "ab-c", "a b", "_ab"})
        EXPECT_EQ(aliases.add(name, "M8"), "'" + name + "'" + bad_name);
    const std::string bad_word =
        " is not a valid word for an alias: it must be one letter and a number, such as M08";
    for (const std::string word : {"", "M", "08", "M8 X1", "MM8", "M-8", "M8.1.1", "M.5"})
        EXPECT_EQ(aliases.add("Jet", word), "'" + word + "'" + bad_word);
    EXPECT_EQ(aliases.add("Jet_on", "M08"), std::nullopt);
    EXPECT_EQ(aliases.add("JET_ON", "M09"), "the alias 'JET_ON' is given twice");
    ASSERT_NE(aliases.find("jet_ON"), nullptr);
    EXPECT_EQ(aliases.find("jet_ON")->number, "08");
    EXPECT_EQ(aliases.find("jet"), nullptr);
}

TEST(NearestName, ReturnsBestMatchWithinTwoChanges) {
    const std::vector<std::string> names = {"WHILE", "GOTO", "THEN"};
    EXPECT_EQ(nearest_name("GOTU", names), "GOTO");
    EXPECT_EQ(nearest_name("WHILEEE", names), "WHILE");
    EXPECT_EQ(nearest_name("XYZ", names), "");
    EXPECT_EQ(nearest_name("G", std::vector<std::string>{"A"}), "") << "nothing of the name would be left";
}

TEST(Aliases, AreFoundByTheirWord) {
    Aliases aliases;
    ASSERT_FALSE(aliases.add("GoBack", "M099"));
    ASSERT_FALSE(aliases.add("Jet", "M08.0"));
    EXPECT_TRUE(aliases.has_alias_of('M', 99));
    EXPECT_TRUE(aliases.has_alias_of('M', 8));
    EXPECT_FALSE(aliases.has_alias_of('G', 99));
    EXPECT_FALSE(aliases.has_alias_of('M', 9));
}

}  // namespace
}  // namespace gsim::lexer::alias_test
