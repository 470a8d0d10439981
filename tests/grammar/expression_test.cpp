#include <gtest/gtest.h>

#include "tests/grammar/parse.h"

namespace gsim::grammar::expression_test {
namespace {

/// The tree of an expression.
std::string tree(const std::string& expression) {
    const Parsed parsed = parse("#9=" + expression + "\n");
    EXPECT_EQ(parsed.messages, "") << expression;
    const std::string start = "assign #9:=";
    return parsed.blocks.size() == 1 && parsed.blocks[0].starts_with(start)
               ? parsed.blocks[0].substr(start.size())
               : "no expression";
}

TEST(Expressions, FollowOperatorPrecedence) {
    EXPECT_EQ(tree("1+2*3"), "(+ 1 (* 2 3))");
    EXPECT_EQ(tree("1*2+3"), "(+ (* 1 2) 3)");
    EXPECT_EQ(tree("[1+2]*3"), "(* (+ 1 2) 3)");
    EXPECT_EQ(tree("1-2-3"), "(- (- 1 2) 3)");
    EXPECT_EQ(tree("8/4/2"), "(/ (/ 8 4) 2)");
    EXPECT_EQ(tree("8/4*2"), "(* (/ 8 4) 2)");
    EXPECT_EQ(tree("8/[4*2]"), "(/ 8 (* 4 2))");
    EXPECT_EQ(tree("1+7 MOD 4*2"), "(+ 1 (* (MOD 7 4) 2))");
    EXPECT_EQ(tree("1 OR 2 AND 3"), "(OR 1 (AND 2 3))");
    EXPECT_EQ(tree("1 XOR 2+3"), "(+ (XOR 1 2) 3)");
    EXPECT_EQ(tree("1+2 EQ 3*4"), "(EQ (+ 1 2) (* 3 4))");
    EXPECT_EQ(tree("[1 LT 2] AND [3 GE 4]"), "(AND (LT 1 2) (GE 3 4))");
}

TEST(Expressions, BindSignsToOperands) {
    EXPECT_EQ(tree("-5"), "(neg 5)");
    EXPECT_EQ(tree("-5*2"), "(* (neg 5) 2)");
    EXPECT_EQ(tree("2*-5"), "(* 2 (neg 5))");
    EXPECT_EQ(tree("2--5"), "(- 2 (neg 5))");
    EXPECT_EQ(tree("+5+ +6"), "(+ 5 6)");
    EXPECT_EQ(tree("-[1+2]/-#3"), "(/ (neg (+ 1 2)) (neg #3))");
    EXPECT_EQ(tree("-SIN[30]"), "(neg (SIN 30))");
}

TEST(Expressions, ParseVariablesAndFunctions) {
    EXPECT_EQ(tree("##1+#[2+#3]"), "(+ (# #1) (# (+ 2 #3)))");
    EXPECT_EQ(tree("sqrt[#1*#1+#2*#2]"), "(SQRT (+ (* #1 #1) (* #2 #2)))");
    EXPECT_EQ(tree("SQR[4]"), "(SQRT 4)");
    EXPECT_EQ(tree("RND[FIX[1.5]+FUP[.5]]"), "(ROUND (+ (FIX 1.5) (FUP .5)))");
}

// ATAN[a]/[b] is the angle whose sides are a and b; ATAN[a]/2 is half of ATAN[a].
TEST(Atan, TakesOneOrTwoSides) {
    EXPECT_EQ(tree("ATAN[1]/[2]"), "(ATAN 1 2)");
    EXPECT_EQ(tree("ATAN[1]/2"), "(/ (ATAN 1) 2)");
    EXPECT_EQ(tree("ATAN[1]/#2"), "(/ (ATAN 1) #2)");
    EXPECT_EQ(tree("ATAN[1]/-[2]"), "(/ (ATAN 1) (neg 2))");
    EXPECT_EQ(tree("ATAN[1]/SIN[2]"), "(/ (ATAN 1) (SIN 2))");
    EXPECT_EQ(tree("ATAN[1]*[2]"), "(* (ATAN 1) 2)");
    EXPECT_EQ(tree("ATAN[1]"), "(ATAN 1)");
    EXPECT_EQ(tree("[ATAN[1]]/[2]"), "(/ (ATAN 1) 2)") << "brackets around it make it a quotient";
    EXPECT_EQ(tree("-ATAN[1]/[2]"), "(neg (ATAN 1 2))");
}

TEST(Atan, MayOccurSeveralTimesInExpression) {
    EXPECT_EQ(tree("3*ATAN[1]/[2]"), "(* 3 (ATAN 1 2))");
    EXPECT_EQ(tree("8/ATAN[1]/[2]"), "(/ 8 (ATAN 1 2))");
    EXPECT_EQ(tree("8 MOD ATAN[1]/[2]"), "(MOD 8 (ATAN 1 2))");
    EXPECT_EQ(tree("1-ATAN[1]/[2]-3"), "(- (- 1 (ATAN 1 2)) 3)");
    EXPECT_EQ(tree("ATAN[1]/[2]/[3]"), "(/ (ATAN 1 2) 3)");
    EXPECT_EQ(tree("ATAN[1]/ATAN[2]/[3]"), "(/ (ATAN 1) (ATAN 2 3))");
    EXPECT_EQ(tree("ATAN[1]/[2]*ATAN[3]/[4]/ATAN[5]/2"), "(/ (/ (* (ATAN 1 2) (ATAN 3 4)) (ATAN 5)) 2)");
    EXPECT_EQ(tree("ATAN[ATAN[1]/[2]/[3]]/[ATAN[4]/5]"), "(ATAN (/ (ATAN 1 2) 3) (/ (ATAN 4) 5))");
}

TEST(Atan, IsResolvedInAmbiguousWords) {
    EXPECT_EQ(parse("X[ATAN[1]/[2]] F[ATAN[3]/4] U[2*ATAN[5]/[6]] G01\n").blocks[0],
              "words X=(ATAN 1 2):axis F=(/ (ATAN 3) 4) U=(* 2 (ATAN 5 6)):axis G=01");
    EXPECT_EQ(parse("X[ATAN[1]/[2]*ATAN[3]/[4]] F[ATAN[3]/4] G04\n").blocks[0],
              "words X=(* (ATAN 1 2) (ATAN 3 4)):time F=(/ (ATAN 3) 4) G=04");
    EXPECT_EQ(parse("P[ATAN[1]/[2]] L[ATAN[3]/4] M98\n").blocks[0],
              "words P=(ATAN 1 2):program L=(/ (ATAN 3) 4) M=98");
}

}  // namespace
}  // namespace gsim::grammar::expression_test
