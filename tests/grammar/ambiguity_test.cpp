// Blocks that keep several readings open for as long as the scanner's bounds admit. The parser must come
// through each of them and read the next block right.
#include <random>

#include <gtest/gtest.h>

#include "tests/grammar/parse.h"

namespace gsim::grammar::ambiguity_test {
namespace {

/// True if the parser did not give up on `line`, and read the block after it.
testing::AssertionResult comes_through(const std::string& line, const Dialect& dialect = dialect_ab9()) {
    const Parsed parsed = parse(line + "\nG1 X5\n", dialect);
    const std::string next = dialect.text().ambiguous_words ? "words G=1 X=5:axis" : "words G=1 X=5";
    if (!parsed.finished || parsed.messages.find("gave up") != std::string::npos)
        return testing::AssertionFailure() << "gave up: " << line << "\n" << parsed.messages;
    if (parsed.blocks.empty() || parsed.blocks.back() != next)
        return testing::AssertionFailure() << "lost the next block: " << line;
    return testing::AssertionSuccess();
}

TEST(LongAmbiguity, BlockOf500WordsDoesNotStopParser) {
    EXPECT_TRUE(comes_through(repeated("X1", " F1", 499)));
    EXPECT_TRUE(comes_through(repeated("X1", " F1", 498) + " G4"));
    EXPECT_TRUE(comes_through(repeated("P1", " F1", 498) + " M98"));
    EXPECT_TRUE(comes_through(repeated("P1", " F1", 498) + " X1"));
    EXPECT_TRUE(comes_through(repeated("", "X1 ", 500)));
    EXPECT_TRUE(comes_through(repeated("", "P1 ", 499) + "G4"));
    EXPECT_TRUE(comes_through(repeated("", "U1X1P1F1", 124) + "M98"));
    EXPECT_TRUE(comes_through(repeated("", "X1 ", 501)));
    EXPECT_TRUE(comes_through(repeated("", "X1 ", 499) + "X Y"));
}

TEST(LongAmbiguity, BlockOf2000SymbolsDoesNotStopParser) {
    EXPECT_TRUE(comes_through(repeated("X[", "1+", 990) + "1] G4"));
    EXPECT_TRUE(comes_through(repeated("X[", "ATAN[1]/[2]*", 160) + "1] G4"));
    EXPECT_TRUE(comes_through(repeated("P[", "ATAN[1]/2+", 160) + "1] M98"));
    EXPECT_TRUE(comes_through(repeated("", "X[1] ", 399) + "G4"));
    EXPECT_TRUE(comes_through(repeated("X", "#", 1900) + "1 G4"));
    EXPECT_TRUE(comes_through(repeated("X", "-", 1900) + "#1"));
    EXPECT_TRUE(comes_through(repeated("", "#1=1 ", 490)));
    EXPECT_TRUE(comes_through(repeated("#1=1", "+1", 2000)));
    EXPECT_TRUE(comes_through(repeated("X[ATAN[", "ATAN[", 97) + "1" + repeated("", "]/[2]", 98) + "] G4"));
}

TEST(LongAmbiguity, ErrorInLongBlockDoesNotStopParser) {
    EXPECT_TRUE(comes_through(repeated("X1", " F1", 300) + " @ G4"));
    EXPECT_TRUE(comes_through(repeated("X1 P1", " F[ATAN[1]/[2]]", 150) + " ] G4"));
    EXPECT_TRUE(comes_through(repeated("", "N1 ", 1000)));
    EXPECT_TRUE(comes_through(repeated("", "/ ", 1500)));
    EXPECT_TRUE(comes_through(repeated("X", "[", 5000)));
}

TEST(LongAmbiguity, LongNgcBlockDoesNotStopParser) {
    const Dialect& ngc = dialect_rs274ngc();
    EXPECT_TRUE(comes_through(repeated("", "X1 ", 500), ngc));
    EXPECT_TRUE(comes_through(repeated("", "X1 ", 1000000), ngc));
    EXPECT_TRUE(comes_through(repeated("", "#1=1 ", 660), ngc));
    EXPECT_TRUE(comes_through(repeated("", "#1=1 ", 10000), ngc));
    EXPECT_TRUE(comes_through(repeated("", "X#1 #2=3 ", 300), ngc));
    EXPECT_TRUE(comes_through(repeated("#1=", "#", 1900) + "1", ngc));
    EXPECT_TRUE(comes_through(repeated("X", "#", 1000000) + "1", ngc));
    EXPECT_TRUE(comes_through(repeated("X[1", "**2", 600) + "]", ngc));
    EXPECT_TRUE(comes_through(repeated("X[1", " EQ 2", 600) + "]", ngc));
    EXPECT_TRUE(comes_through(repeated("X", "[", 1000000), ngc));
    EXPECT_TRUE(comes_through(repeated("X", "SIN[", 1000000), ngc));
    EXPECT_TRUE(comes_through(repeated("o1 call ", "[1]", 1000000), ngc));
    EXPECT_TRUE(comes_through(repeated("", "o1 ", 1000000), ngc));
    EXPECT_TRUE(comes_through(repeated("", "#<", 30000), ngc));
    EXPECT_TRUE(comes_through(repeated("", "O<", 30000), ngc));
    EXPECT_TRUE(comes_through(repeated("", "N1", 1000000), ngc));
    EXPECT_TRUE(comes_through(repeated("X[", "ATAN[1]/[2]*", 160) + "1]", ngc));
    EXPECT_TRUE(comes_through(repeated("X[", "EXISTS[", 1000), ngc));
}

TEST(LongAmbiguity, RandomNgcBlocksDoNotStopParser) {
    constexpr const char* kPieces[] = {"X1 ",       "X[1+2]",    "P#1 ",   "F[ATAN[1]/[2]*3]",
                                       "G4 ",       "M98 ",      "#1=2 ",  "#<a>=#2 ",
                                       "#[1]=-3",   "##4=5",     "X#<b>",  "@1 ^2",
                                       "o1 ",       "o<x> call", "[1]",    "if ",
                                       "sub",       "**",        "] ",     "EXISTS[#1]",
                                       "[2 EQ 3] ", "AND ",      "; ",     "(c)",
                                       "= ",        "/",         "SIN[1]", "ATAN[1]/[2]",
                                       "N1"};
    std::mt19937 random(21);
    for (int i = 0; i < 3000; ++i) {
        std::string line;
        for (std::size_t count = random() % 40; count > 0; --count)
            line += kPieces[random() % std::size(kPieces)];
        ASSERT_TRUE(comes_through(line, dialect_rs274ngc())) << "block " << i << ": " << line;
    }
}

TEST(LongAmbiguity, RandomAb9BlocksDoNotStopParser) {
    constexpr const char* kPieces[] = {"X1 ",
                                       "U[1+2] ",
                                       "P#1 ",
                                       "F[ATAN[1]/[2]*3] ",
                                       "G4 ",
                                       "M98 ",
                                       "Y2 ",
                                       "P5 ",
                                       "X-#2 ",
                                       "S5 ",
                                       "Q[8/ATAN[1]/[2]] ",
                                       "L2 ",
                                       "X5 ",
                                       "@ ",
                                       "] ",
                                       "#1=2 ",
                                       "ATAN[1]/[2] ",
                                       "[",
                                       "/",
                                       "IF[1]THEN "};
    std::mt19937 random(20);
    for (int i = 0; i < 3000; ++i) {
        std::string line;
        for (std::size_t count = random() % 60; count > 0; --count)
            line += kPieces[random() % std::size(kPieces)];
        ASSERT_TRUE(comes_through(line)) << "block " << i;
    }
}

}  // namespace
}  // namespace gsim::grammar::ambiguity_test
